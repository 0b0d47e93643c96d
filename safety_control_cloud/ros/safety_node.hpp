// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <string>

#include "../core/safety_control.hpp"
#include "input/arrival.hpp"
#include "input/depth_input.hpp"
#include "output/diagnostics.hpp"
#include "reconfigure.hpp"
#include "input/camera_place.hpp"

namespace safety_control_cloud {

/// Wires SafetyControl to ROS: every cloud leads to exactly one command, and so does every period without one.
/// Decides nothing itself.
class SafetyNode {
 public:
  /// Throws BadParameters if the private parameters are unfit to drive with.
  SafetyNode(ros::NodeHandle handle, ros::NodeHandle private_handle, Delivery delivery);
  ~SafetyNode();  ///< the last command is zero
  SafetyNode(const SafetyNode&) = delete;
  SafetyNode& operator=(const SafetyNode&) = delete;

 private:
  void on_arrival(const Arrival& arrival);
  void on_quiet(const ros::SteadyTimerEvent&);
  bool on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& answer);

  Decision decide(const Arrival& arrival);
  Placing placing_of(const std_msgs::Header& cloud) const;
  void publish(const Decision& decision);
  void publish_markers(const Decision& decision);
  void log(const Decision& decision);
  void wake_when_quiet();

  SafetyControl control_;
  std::unique_ptr<CameraPlace> camera_place_;  ///< only with a target frame
  ros::Publisher command_, output_, state_, markers_;
  ros::Subscriber clouds_;
  std::unique_ptr<DepthInput> depths_;  ///< in place of clouds_, if these are the input
  ros::ServiceServer reset_;
  ros::SteadyTimer quiet_;
  Reconfigure reconfigure_;
  Diagnostics diagnostics_;
  ros::SteadyTime last_cloud_, last_log_, last_markers_;
  std_msgs::Header header_;
  Decision logged_;
};

}  // namespace safety_control_cloud
