// SPDX-License-Identifier: BSD-3-Clause
// Between Gazebo's types and ROS messages.
#pragma once

#include <gazebo/common/Time.hh>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Twist.h>
#include <ignition/math/Pose3.hh>
#include <ros/time.h>

namespace standin {

inline ros::Time to_ros(const gazebo::common::Time& time) {
  return {static_cast<uint32_t>(time.sec), static_cast<uint32_t>(time.nsec)};
}

inline geometry_msgs::Vector3 to_ros(const ignition::math::Vector3d& vector) {
  geometry_msgs::Vector3 message;
  message.x = vector.X();
  message.y = vector.Y();
  message.z = vector.Z();
  return message;
}

inline geometry_msgs::Quaternion to_ros(const ignition::math::Quaterniond& turn) {
  geometry_msgs::Quaternion message;
  message.x = turn.X();
  message.y = turn.Y();
  message.z = turn.Z();
  message.w = turn.W();
  return message;
}

inline geometry_msgs::Pose to_ros(const ignition::math::Pose3d& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.Pos().X();
  message.position.y = pose.Pos().Y();
  message.position.z = pose.Pos().Z();
  message.orientation = to_ros(pose.Rot());
  return message;
}

inline geometry_msgs::Twist to_ros(const ignition::math::Vector3d& linear, const ignition::math::Vector3d& angular) {
  geometry_msgs::Twist message;
  message.linear = to_ros(linear);
  message.angular = to_ros(angular);
  return message;
}

inline ignition::math::Vector3d to_gazebo(const geometry_msgs::Vector3& vector) {
  return {vector.x, vector.y, vector.z};
}

inline ignition::math::Pose3d to_gazebo(const geometry_msgs::Pose& pose) {
  const auto& at = pose.position;
  const auto& turn = pose.orientation;
  return {at.x, at.y, at.z, turn.w, turn.x, turn.y, turn.z};
}

}  // namespace standin
