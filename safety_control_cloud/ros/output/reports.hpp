// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <std_msgs/Header.h>

#include <string>

#include "../../core/decision.hpp"
#include "../../core/settings.hpp"
#include "log.hpp"

namespace safety_control_cloud {

/// Says what was decided: on ~state, on ~markers, and in the log at every change and once a second.
class Reports {
 public:
  Reports(ros::NodeHandle& private_handle, Log& log);

  /// ~reset was obeyed.
  void count_reset() { ++resets_; }

  /// `cloud` is the header of the latest cloud.
  void say(const Decision& decision, const Settings& settings, const std_msgs::Header& cloud);

 private:
  void say_markers(const Decision& decision, const Settings& settings, const std_msgs::Header& cloud);
  void say_in_log(const Decision& decision, const std_msgs::Header& cloud);

  Log& log_;
  const std::string node_;  ///< its resolved name
  ros::Publisher state_, markers_;
  ros::SteadyTime last_log_, last_markers_;
  Decision logged_;
  std::uint32_t resets_ = 0;
};

}  // namespace safety_control_cloud
