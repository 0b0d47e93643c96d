// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <sensor_msgs/LaserScan.h>

#include <string>

#include "arrival.hpp"
#include "input.hpp"

namespace safety_control_cloud {

/// The scan of a message, borrowed from it.
Scan scan_in(const sensor_msgs::LaserScan& message);

/// Scans of a planar range finder, the latest only.
class ScanInput : public Input {
 public:
  ScanInput(ros::NodeHandle& handle, const std::string& topic, OnArrival on_arrival);

 private:
  void on_message(const ros::MessageEvent<const sensor_msgs::LaserScan>& event);

  OnArrival on_arrival_;
  ScanPoints points_;
  ros::Subscriber subscriber_;
};

}  // namespace safety_control_cloud
