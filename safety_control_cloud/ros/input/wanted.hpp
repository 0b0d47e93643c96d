// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/ros.h>

#include <functional>
#include <optional>

#include "../../core/guard/settings.hpp"

namespace safety_control_cloud {

/// What somebody wants, and its stamp [s] if it has one.
using OnWanted = std::function<void(const geometry_msgs::Twist&, std::optional<double>)>;

/// cmd_vel_in, of one type or the other; what waits behind the latest is dropped.
ros::Subscriber subscribe_to_wanted(ros::NodeHandle& handle, CommandType type, OnWanted on_wanted);

}  // namespace safety_control_cloud
