// SPDX-License-Identifier: BSD-3-Clause
#include "facing.hpp"

#include <algorithm>
#include <cstddef>

#include "pose.hpp"

namespace safety_control_cloud {

Placement in_turned_frame(const Placement& placement, double angle) {
  if (angle == 0.0) return placement;
  Placement turned = placement;
  auto& [x, y, z] = turned.rows;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto [right, down, forward] = in_turned_axes({x[i], y[i], z[i]}, angle);
    x[i] = right, y[i] = down, z[i] = forward;
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
