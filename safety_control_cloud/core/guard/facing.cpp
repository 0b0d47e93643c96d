// SPDX-License-Identifier: BSD-3-Clause
#include "facing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "pose.hpp"

namespace safety_control_cloud {

Placement in_turned_frame(const Placement& placement, double angle) {
  if (angle == 0.0) return placement;
  const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  Placement turned = placement;
  for (std::size_t i = 0; i < 4; ++i) {
    const float right = placement.rows[0][i], forward = placement.rows[2][i];
    turned.rows[0][i] = c * right + s * forward;
    turned.rows[2][i] = c * forward - s * right;
  }
  return turned;
}

Silhouette silhouette_of(const Footprint& footprint, double angle) {
  Silhouette silhouette{footprint.radius, footprint.radius, footprint.radius};
  for (const Point2& corner : footprint.polygon) {
    const Point2 seen = turned(corner, -angle);
    silhouette.front = std::max(silhouette.front, seen.x);
    silhouette.left = std::max(silhouette.left, seen.y);
    silhouette.right = std::max(silhouette.right, -seen.y);
  }
  return silhouette;
}

}  // namespace safety_control_cloud
