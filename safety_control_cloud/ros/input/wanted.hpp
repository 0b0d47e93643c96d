// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/ros.h>

#include <functional>
#include <optional>
#include <string>

#include "../../core/guard/settings.hpp"

namespace safety_control_cloud {

/// What somebody wants, and its stamp [s] if it has one.
using OnWanted = std::function<void(const geometry_msgs::Twist&, std::optional<double>)>;

/// One that tells no time was not handed over, since it may be of any: it is said who.
using OnUntimely = std::function<void(const std::string& publisher)>;

/// cmd_vel_in, of one type or the other; what waits behind the latest is dropped. Of a publisher that latches, what
/// comes first over a connection may be of long ago: it is handed over only with a stamp.
ros::Subscriber subscribe_to_wanted(ros::NodeHandle& handle, CommandType type, OnWanted on_wanted,
                                    OnUntimely on_untimely);

}  // namespace safety_control_cloud
