// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <string>

#include "../../core/look/placement.hpp"

namespace safety_control_cloud {

/// Knows where the camera is in the target frame (x forward, y left, z up).
class CameraPlace {
 public:
  explicit CameraPlace(const std::string& target_frame);

  /// Where the camera was when the cloud was taken. A transform that is missing or too old is none.
  Placing at(const std_msgs::Header& cloud) const;

  const tf2_ros::Buffer& buffer() const { return buffer_; }

 private:
  std::string target_frame_;
  tf2_ros::Buffer buffer_;
  ros::CallbackQueue heard_;
  ros::NodeHandle handle_;  ///< of that queue
  tf2_ros::TransformListener listener_;
  ros::AsyncSpinner hearing_;  ///< goes first
};

}  // namespace safety_control_cloud
