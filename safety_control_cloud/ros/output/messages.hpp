// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Twist.h>
#include <safety_control_cloud/SafetyState.h>
#include <sensor_msgs/PointCloud2.h>

#include "../../core/decision.hpp"
#include "../../core/settings.hpp"

namespace safety_control_cloud {

geometry_msgs::Twist to_twist(const Decision& decision);

/// `cloud` is the header of the cloud decided on.
SafetyState to_state(const Decision& decision, const Settings& settings, const std_msgs::Header& cloud);

/// The crop as a message, with the header of the cloud it was cut from. Not pcl_ros's own transport of a pcl cloud: PCL
/// keeps stamps in microseconds, and whoever pairs /output with its cloud by stamp needs the same one.
sensor_msgs::PointCloud2 to_output(const Cloud& crop, const std_msgs::Header& header);

}  // namespace safety_control_cloud
