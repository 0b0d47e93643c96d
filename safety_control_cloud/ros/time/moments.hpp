// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <std_msgs/Header.h>

#include "../../core/sensor.hpp"

namespace safety_control_cloud {

/// [s] Not ros::Time's own difference, which throws beyond 2^31 s: a stamp may be anything.
inline double age_of(const std_msgs::Header& cloud) { return ros::Time::now().toSec() - cloud.stamp.toSec(); }

/// Taken once, where a callback begins: the process may stand still anywhere in it, and what it then goes on with is as
/// old as that.
inline Instant now() { return Instant{ros::SteadyTime::now().toSec(), ros::Time::now().toSec()}; }

inline double seconds_since(const ros::SteadyTime& then) { return (ros::SteadyTime::now() - then).toSec(); }
inline double seconds_since(const Instant& then) { return ros::SteadyTime::now().toSec() - then.steady; }

}  // namespace safety_control_cloud
