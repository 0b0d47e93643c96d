// SPDX-License-Identifier: BSD-3-Clause
#include "silhouette.hpp"

#include <algorithm>

#include "pose.hpp"

namespace safety_control_cloud {

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
