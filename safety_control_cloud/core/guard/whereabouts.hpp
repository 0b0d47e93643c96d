// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pose.hpp"

namespace safety_control_cloud {

/// By how much a way may be off.
struct Drift {
  double place = 0.0, heading = 0.0;  ///< [m], [rad]
};

/// Where the robot is, in a frame that rests.
struct Whereabouts {
  Pose2 pose;
  std::vector<Pose2> or_else = {};  ///< where it may be instead: the true one lies among all of them
  double drift = 0.0;               ///< [m/m], [rad/rad] by which the way there may be off
  Drift unexplained = {};           ///< of the way there, since some moment: what no motion explains
};

}  // namespace safety_control_cloud
