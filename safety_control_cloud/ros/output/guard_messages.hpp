// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Twist.h>
#include <safety_control_cloud/Blocked.h>
#include <safety_control_cloud/SafetyState.h>

#include "../../core/decision.hpp"
#include "../../core/guard_control.hpp"

namespace safety_control_cloud {

/// Equal in every bit, both ways.
Command to_command(const geometry_msgs::Twist& twist);
geometry_msgs::Twist to_twist(const Command& command);
bool same_bits(const geometry_msgs::Twist& a, const geometry_msgs::Twist& b);

/// As the drive mode would say it, for what both share.
Decision to_decision(const Guarded& answer);

/// `cloud` is the header of the latest cloud.
SafetyState to_state(const Guarded& answer, const Settings& settings, const std_msgs::Header& cloud);

/// Without its header's stamp.
Blocked to_blocked(const Guarded& answer, const Settings& settings);

}  // namespace safety_control_cloud
