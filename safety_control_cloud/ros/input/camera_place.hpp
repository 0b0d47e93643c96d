// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <functional>
#include <string>

#include "../../core/look/placement.hpp"
#include "../time/queue_thread.hpp"

namespace safety_control_cloud {

/// Knows where the camera is in the target frame (x forward, y left, z up).
class CameraPlace {
 public:
  using Say = std::function<void(const std::string&)>;

  /// `warn` is told of transforms that cannot be taken, from any thread.
  CameraPlace(const std::string& target_frame, Say warn);

  /// Where the camera was when the cloud was taken. A transform that is missing or too old is none.
  Placing at(const std_msgs::Header& cloud) const;

  const tf2_ros::Buffer& buffer() const { return buffer_; }

 private:
  void on_thrown(const std::string& problem);

  std::string target_frame_;
  tf2_ros::Buffer buffer_;
  ros::CallbackQueue heard_;
  ros::NodeHandle handle_;  ///< of that queue
  tf2_ros::TransformListener listener_;
  const Say warn_;
  std::string told_;     ///< of the thread alone
  QueueThread hearing_;  ///< goes first
};

}  // namespace safety_control_cloud
