// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_input.hpp"

#include <ros/ros.h>

#include "cloud_message.hpp"
#include "received_cloud.hpp"

namespace safety_control_cloud {
namespace {

using sensor_msgs::PointCloud2;

ros::Subscriber subscribe_in_place(ros::NodeHandle& handle, const std::string& topic, const OnArrival& on_arrival) {
  return subscribe_received<PointCloud2>(handle, topic, [on_arrival](auto& message, const std::string& source) {
    Arrival arrival = arrival_in(message);
    arrival.source = source;
    on_arrival(arrival);
  });
}

ros::Subscriber subscribe_shared(ros::NodeHandle& handle, const std::string& topic, const OnArrival& on_arrival) {
  using Event = ros::MessageEvent<const PointCloud2>;
  const boost::function<void(const Event&)> on_message = [on_arrival](const Event& event) {
    const PointCloud2& cloud = *event.getConstMessage();
    on_arrival(
        Arrival{cloud.header, readable([&] { return view_of(cloud); }), source_of(event.getConnectionHeaderPtr())});
  };
  return handle.subscribe<PointCloud2>(topic, 1, on_message, nullptr, ros::TransportHints().tcpNoDelay());
}

}  // namespace

CloudInput::CloudInput(ros::NodeHandle& handle, const std::string& topic, Delivery delivery,
                       const OnArrival& on_arrival)
    : subscriber_((delivery == Delivery::InPlace ? subscribe_in_place : subscribe_shared)(handle, topic, on_arrival)) {}

}  // namespace safety_control_cloud
