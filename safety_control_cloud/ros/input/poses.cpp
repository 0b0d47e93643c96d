// SPDX-License-Identifier: BSD-3-Clause
#include "poses.hpp"

#include <cmath>

namespace safety_control_cloud {
namespace {

double heading_of(const geometry_msgs::Quaternion& turn) {
  return std::atan2(2.0 * (turn.w * turn.z + turn.x * turn.y), 1.0 - 2.0 * (turn.y * turn.y + turn.z * turn.z));
}

}  // namespace

Pose2 pose_of(const geometry_msgs::Pose& pose) {
  return {{pose.position.x, pose.position.y}, heading_of(pose.orientation)};
}

Pose2 pose_of(const geometry_msgs::Transform& transform) {
  return {{transform.translation.x, transform.translation.y}, heading_of(transform.rotation)};
}

}  // namespace safety_control_cloud
