// SPDX-License-Identifier: BSD-3-Clause
#include "scan_input.hpp"

#include <ros/ros.h>

#include <utility>

#include "source.hpp"

namespace safety_control_cloud {

Scan scan_in(const sensor_msgs::LaserScan& message) {
  Scan scan;
  scan.angle_min = message.angle_min, scan.angle_max = message.angle_max;
  scan.angle_increment = message.angle_increment;
  scan.time_increment = message.time_increment, scan.scan_time = message.scan_time;
  scan.range_min = message.range_min, scan.range_max = message.range_max;
  scan.ranges = message.ranges.data();
  scan.size = message.ranges.size();
  return scan;
}

ScanInput::ScanInput(ros::NodeHandle& handle, const std::string& topic, OnArrival on_arrival)
    : on_arrival_(std::move(on_arrival)),
      subscriber_(handle.subscribe<sensor_msgs::LaserScan>(
          topic, 1,
          boost::function<void(const ros::MessageEvent<const sensor_msgs::LaserScan>&)>(
              [this](const ros::MessageEvent<const sensor_msgs::LaserScan>& event) { on_message(event); }),
          nullptr, ros::TransportHints().tcpNoDelay())) {}

void ScanInput::on_message(const ros::MessageEvent<const sensor_msgs::LaserScan>& event) {
  const sensor_msgs::LaserScan& message = *event.getConstMessage();
  const auto read = [&] { return points_.of(scan_in(message)); };
  on_arrival_(Arrival{message.header, readable(read), source_of(event.getConnectionHeaderPtr())});
}

}  // namespace safety_control_cloud
