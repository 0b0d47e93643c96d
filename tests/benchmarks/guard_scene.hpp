// SPDX-License-Identifier: BSD-3-Clause
// What the guard's benchmark shows: two cameras and a laser, and where they sit on a robot that stands.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "scene_message.hpp"

namespace safety_control_cloud {

constexpr std::size_t with_colours = 32;  ///< [byte] a point, as depth_image_proc's xyzrgb; 16: its xyz

inline sensor_msgs::PointCloud2 cloud_of(const std::string& frame, std::size_t point_step = with_colours) {
  CameraPicture picture;
  picture.point_step = point_step;
  picture.nan_share = 0.3;
  auto message = message_of(picture);
  message.header.frame_id = frame;
  return message;
}

inline sensor_msgs::LaserScan scan_of(const std::string& frame) {
  sensor_msgs::LaserScan scan;
  scan.header.frame_id = frame;
  scan.ranges.assign(720, 3.0f);
  scan.angle_increment = static_cast<float>(2.0 * M_PI / 720.0);
  scan.angle_min = static_cast<float>(-M_PI);
  scan.angle_max = static_cast<float>(M_PI) - scan.angle_increment;
  scan.scan_time = 0.05f, scan.range_min = 0.1f, scan.range_max = 10.0f;
  return scan;
}

/// A frame in another; as quaternion x, y, z, w, then forward and up [m].
inline geometry_msgs::TransformStamped placed(const std::string& frame, const std::string& in,
                                              const std::array<double, 4>& turn, double x, double z) {
  geometry_msgs::TransformStamped place;
  place.header.stamp = ros::Time::now();
  place.header.frame_id = in;
  place.child_frame_id = frame;
  place.transform.translation.x = x;
  place.transform.translation.z = z;
  auto& rotation = place.transform.rotation;
  rotation.x = turn[0], rotation.y = turn[1], rotation.z = turn[2], rotation.w = turn[3];
  return place;
}

/// The sensors' in base_footprint, and what other nodes ask for: base_link, and odom.
inline std::vector<geometry_msgs::TransformStamped> places() {
  const std::array<double, 4> as_is{0.0, 0.0, 0.0, 1.0};
  return {placed("front", "base_footprint", {-0.5, 0.5, -0.5, 0.5}, 0.1, 0.3),
          placed("rear", "base_footprint", {0.5, 0.5, -0.5, -0.5}, -0.1, 0.3),
          placed("laser", "base_footprint", as_is, 0.0, 0.3), placed("base_link", "base_footprint", as_is, 0.0, 0.01),
          placed("base_footprint", "odom", as_is, 0.0, 0.0)};
}

}  // namespace safety_control_cloud
