// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <std_msgs/Header.h>

#include <algorithm>

#include "../core/sensor.hpp"
#include "../core/settings.hpp"

namespace safety_control_cloud {

/// [s] Not ros::Time's own difference, which throws beyond 2^31 s: a stamp may be anything.
inline double age_of(const std_msgs::Header& cloud) { return ros::Time::now().toSec() - cloud.stamp.toSec(); }

inline double seconds_since(const ros::SteadyTime& then) { return (ros::SteadyTime::now() - then).toSec(); }

inline Instant now() { return Instant{ros::SteadyTime::now().toSec(), ros::Time::now().toSec()}; }

/// [s] in which a node that runs does something.
inline double longest_gap(const Settings& settings) {
  return std::max(settings.source_timeout, 2.0 / settings.publish_rate);
}

}  // namespace safety_control_cloud
