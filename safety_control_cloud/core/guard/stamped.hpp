// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace safety_control_cloud {

/// How far the stamp of a command may be from the moment at which it comes.
struct StampLimits {
  double greatest_age;  ///< [s]
  double tolerance;     ///< [s] ahead; 0 = any
};

/// Why a command with this stamp that comes now is not to be obeyed; nothing: it is. Both [s] of ROS time.
std::optional<std::string> refusal_of_stamp(double stamp, double now, const StampLimits& limits);

}  // namespace safety_control_cloud
