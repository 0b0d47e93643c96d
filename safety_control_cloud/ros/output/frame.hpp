// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <std_msgs/Header.h>

#include <string>

#include "../../core/settings.hpp"

namespace safety_control_cloud {

/// The frame in which the corridor lies, and its axes there.
class CorridorFrame {
 public:
  CorridorFrame(const Settings& settings, const std_msgs::Header& cloud)
      : is_optical_(settings.target_frame.empty()), id_(is_optical_ ? cloud.frame_id : settings.target_frame) {}

  const std::string& id() const { return id_; }

  /// A point given in the corridor's axes (x right, y down, z forward).
  geometry_msgs::Point point(double right, double down, double forward) const {
    geometry_msgs::Point point;
    point.x = is_optical_ ? right : forward;
    point.y = is_optical_ ? down : -right;
    point.z = is_optical_ ? forward : -down;
    return point;
  }

 private:
  bool is_optical_;
  std::string id_;
};

}  // namespace safety_control_cloud
