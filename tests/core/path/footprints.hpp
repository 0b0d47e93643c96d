// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "../../../safety_control_cloud/core/input/angle.hpp"
#include "../../../safety_control_cloud/core/path/outline.hpp"

namespace safety_control_cloud {

constexpr double infinity = std::numeric_limits<double>::infinity();

inline Outline circle(double radius, double margin = 0.0) { return Outline({{}, radius, margin}); }

inline Outline polygon(std::vector<Point2> corners, double margin = 0.0) {
  return Outline({std::move(corners), 0.0, margin});
}

/// 2 m long and 0.2 m wide, behind the origin: the footprint of the peers' tests.
inline Outline long_robot(double margin = 0.0) {
  return polygon({{-2.0, -0.1}, {0.0, -0.1}, {0.0, 0.1}, {-2.0, 0.1}}, margin);
}

/// 1 m wide around the origin, open ahead between two arms of 0.2 m.
inline Outline fork(double margin = 0.0) {
  return polygon(
      {{-0.5, -0.5}, {0.5, -0.5}, {0.5, -0.3}, {-0.3, -0.3}, {-0.3, 0.3}, {0.5, 0.3}, {0.5, 0.5}, {-0.5, 0.5}}, margin);
}

}  // namespace safety_control_cloud
