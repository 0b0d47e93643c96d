// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <std_msgs/Header.h>

#include <string>

#include "../../core/guard_control.hpp"
#include "log.hpp"

namespace safety_control_cloud {

/// Says what the guard let through: on ~state, on ~blocked and ~markers, and in the log at every change and once a
/// second while something is taken.
class GuardReports {
 public:
  GuardReports(ros::NodeHandle& private_handle, Log& log);

  /// ~reset was obeyed.
  void count_reset() { ++resets_; }

  /// `cloud` is the header of the latest cloud.
  void say(const Guarded& answer, const Settings& settings, const std_msgs::Header& cloud);

 private:
  void say_blocked(const Guarded& answer, const Settings& settings);
  void say_markers(const Guarded& answer, const Settings& settings);
  void say_override(const Guarded& answer);
  void say_in_log(const Guarded& answer, const std_msgs::Header& cloud);

  Log& log_;
  const std::string node_;
  ros::Publisher state_, blocked_, markers_;
  ros::SteadyTime last_log_, last_markers_;
  Guarded logged_, blocked_by_;
  bool said_blocked_ = false, overridden_ = false;
  std::uint32_t resets_ = 0;
};

}  // namespace safety_control_cloud
