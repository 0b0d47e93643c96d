// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "../input/cloud.hpp"

namespace safety_control_cloud {

/// The space the robot is about to drive through (x right, y down, z forward), limits inclusive.
/// float32 like pcl::PassThrough's limits, so that a point on a limit falls on the same side in both.
struct Corridor {
  float x_min = -0.30f;        ///< [m] to the left
  float x_max = 0.30f;         ///< [m] to the right
  float y_min = -0.25f;        ///< [m] up
  float y_max = 0.20f;         ///< [m] down
  float range_min = 0.0f;      ///< [m] a return lies farther than this along the sensor's z; (0, 0, 0) is no return
  std::size_t min_points = 1;  ///< this many points make an obstacle

  bool spans(float x) const { return x >= x_min && x <= x_max; }
  bool holds(const Point& point) const { return spans(point.x) && point.y >= y_min && point.y <= y_max; }
};

/// Whether they end at the same places.
inline bool same_limits(const Corridor& a, const Corridor& b) {
  return a.x_min == b.x_min && a.x_max == b.x_max && a.y_min == b.y_min && a.y_max == b.y_max;
}

}  // namespace safety_control_cloud
