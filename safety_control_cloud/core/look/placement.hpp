// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <variant>

#include "../input/cloud.hpp"

namespace safety_control_cloud {

/// Where the camera sits: takes a point from the cloud's frame to the corridor's axes (x right, y down, z forward).
/// Rows of a 3x4 matrix [rotation | translation in m].
struct Placement {
  std::array<std::array<float, 4>, 3> rows = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

  /// In exactly this order of operations, so that every method gets the same float32.
  Point operator()(float x, float y, float z) const {
    const auto along = [&](const std::array<float, 4>& row) {
      return ((row[0] * x + row[1] * y) + row[2] * z) + row[3];
    };
    return Point(along(rows[0]), along(rows[1]), along(rows[2]));
  }

  /// The other way round.
  Point seen(const Point& placed) const {
    const auto &x = rows[0], &y = rows[1], &z = rows[2];  // clang captures no bindings
    const float right = placed.x - x[3], down = placed.y - y[3], forward = placed.z - z[3];
    const auto along = [&](std::size_t axis) { return x[axis] * right + y[axis] * down + z[axis] * forward; };
    return Point(along(0), along(1), along(2));
  }
};

/// A direction or a place of the corridor's axes, in those of one that leads elsewhere: `angle` [rad] to the left of
/// it.
std::array<float, 3> in_turned_axes(const std::array<float, 3>& axes, double angle);

/// The same of a camera's place.
Placement in_turned_frame(const Placement& placement, double angle);

/// The corridor lies in the camera's own optical frame.
struct OpticalFrame {};

/// The corridor lies in another frame and nobody knows where the camera is in it.
struct NoTransform {
  std::string reason;
};

using Placing = std::variant<OpticalFrame, Placement, NoTransform>;

/// The placement of a camera whose frame [rotation | translation in m] takes to a target frame (x forward, y left,
/// z up); none if that is not finite.
Placing placing_of(const Eigen::Matrix<double, 3, 4>& cloud_in_target);

}  // namespace safety_control_cloud
