// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <tf2_ros/buffer.h>

#include <optional>
#include <string>

#include "../../core/guard/pose.hpp"

namespace safety_control_cloud {

/// Where TF says that the robot is, in a frame that rests.
class TfOdometry {
 public:
  struct Told {
    double stamp;  ///< [s, ROS]
    Pose2 pose;
  };

  TfOdometry(const std::string& odom_frame, const std::string& base_frame)
      : odom_frame_(odom_frame), base_frame_(base_frame) {}

  /// The latest, if it was not told yet. What TF does not know is none.
  std::optional<Told> next(const tf2_ros::Buffer& buffer);

  /// Why it has not told any so far; empty once it has.
  const std::string& why_nothing() const { return why_nothing_; }

 private:
  std::string odom_frame_, base_frame_, why_nothing_;
  ros::Time told_;
};

}  // namespace safety_control_cloud
