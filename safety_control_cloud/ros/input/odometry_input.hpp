// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <functional>
#include <optional>
#include <string>

#include "../../core/guard_control.hpp"
#include "tf_odometry.hpp"

namespace safety_control_cloud {

/// Where the robot goes, on its way into the control: from nav_msgs/Odometry, or with an odom_frame from TF.
class OdometryInput {
 public:
  /// What it is told of is told to `control`, after a `beat`; `warn`, once each, of a frame that is not base_frame and
  /// of which `buffer` does not tell where that is, of two that publish it in turn, and of an odom_frame that TF does
  /// not know.
  OdometryInput(ros::NodeHandle& handle, GuardControl& control, const tf2_ros::Buffer& buffer,
                std::function<void()> beat, std::function<void(const std::string&)> warn);
  OdometryInput(const OdometryInput&) = delete;
  OdometryInput& operator=(const OdometryInput&) = delete;

  /// What TF knows by now, if it is to be asked.
  void ask();

 private:
  void on_message(const ros::MessageEvent<nav_msgs::Odometry const>& event);
  std::optional<Pose2> base_in(const nav_msgs::Odometry& odometry);
  void note_publisher(const std::string& name);
  void warn_of_frame_that_nobody_knows();

  GuardControl& control_;
  const tf2_ros::Buffer& buffer_;
  std::function<void()> beat_;
  std::function<void(const std::string&)> warn_;
  std::optional<TfOdometry> transforms_;
  ros::Subscriber subscriber_;
  std::string latest_, before_;  ///< who publishes: the latest, and the latest other one
  std::optional<Pose2> fixed_;   ///< where base_frame is in another frame of which it tells, as at first
  bool warned_of_frame_ = false, warned_of_two_ = false;
  const ros::SteadyTime began_ = ros::SteadyTime::now();
};

}  // namespace safety_control_cloud
