// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "../../../safety_control_cloud/core/look/placement.hpp"

namespace safety_control_cloud {

/// The place of a TurtleBot's Xtion in base_footprint.
inline Placing xtion() {
  Eigen::Matrix<double, 3, 4> place;
  place << 0, 0, 1, -0.087, -1, 0, 0, 0.0, 0, -1, 0, 0.2972;
  return placing_of(place);
}

}  // namespace safety_control_cloud
