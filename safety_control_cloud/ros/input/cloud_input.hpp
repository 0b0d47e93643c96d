// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <string>

#include "arrival.hpp"
#include "input.hpp"

namespace safety_control_cloud {

/// Clouds, the latest only.
class CloudInput : public Input {
 public:
  CloudInput(ros::NodeHandle& handle, const std::string& topic, Delivery delivery, const OnArrival& on_arrival);

 private:
  ros::Subscriber subscriber_;
};

}  // namespace safety_control_cloud
