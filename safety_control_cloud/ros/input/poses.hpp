// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>

#include "../../core/guard/pose.hpp"

namespace safety_control_cloud {

/// From above. A quaternion that is none leads to a heading that is none, which the core refuses.
Pose2 pose_of(const geometry_msgs::Pose& pose);
Pose2 pose_of(const geometry_msgs::Transform& transform);

}  // namespace safety_control_cloud
