// SPDX-License-Identifier: BSD-3-Clause
#include "wanted.hpp"

#include <geometry_msgs/TwistStamped.h>

#include <utility>

namespace safety_control_cloud {
namespace {

template <class Message>
ros::Subscriber subscribe(ros::NodeHandle& handle, std::function<void(const Message&)> on_message) {
  using Pointer = typename Message::ConstPtr;
  return handle.subscribe<Message>(
      "cmd_vel_in", 1,
      boost::function<void(const Pointer&)>([on_message](const Pointer& message) { on_message(*message); }), nullptr,
      ros::TransportHints().tcpNoDelay());
}

}  // namespace

ros::Subscriber subscribe_to_wanted(ros::NodeHandle& handle, CommandType type, OnWanted on_wanted) {
  if (type == CommandType::Twist)
    return subscribe<geometry_msgs::Twist>(
        handle, [on_wanted](const geometry_msgs::Twist& wanted) { on_wanted(wanted, std::nullopt); });
  return subscribe<geometry_msgs::TwistStamped>(handle, [on_wanted](const geometry_msgs::TwistStamped& wanted) {
    on_wanted(wanted.twist, wanted.header.stamp.toSec());
  });
}

}  // namespace safety_control_cloud
