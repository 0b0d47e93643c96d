// SPDX-License-Identifier: BSD-3-Clause
#include "arrival.hpp"

#include "messages.hpp"
#include "received_cloud.hpp"

namespace safety_control_cloud {

ros::Subscriber subscribe_in_place(ros::NodeHandle& handle, const std::string& topic, const OnArrival& on_arrival) {
  using Pointer = boost::shared_ptr<const ReceivedCloud>;
  const auto done_while_read = [](const Pointer&) {};
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const Pointer&>(
      topic, 1, done_while_read, [on_arrival] { return boost::make_shared<ReceivedCloud>(ReceivedCloud{on_arrival}); });
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  return handle.subscribe(options);
}

ros::Subscriber subscribe_shared(ros::NodeHandle& handle, const std::string& topic, const OnArrival& on_arrival) {
  using Event = ros::MessageEvent<const sensor_msgs::PointCloud2>;
  const boost::function<void(const Event&)> on_message = [on_arrival](const Event& event) {
    const sensor_msgs::PointCloud2& cloud = *event.getConstMessage();
    on_arrival(Arrival{cloud.header, readable([&] { return view_of(cloud); }), event.getPublisherName()});
  };
  return handle.subscribe<sensor_msgs::PointCloud2>(topic, 1, on_message, nullptr, ros::TransportHints().tcpNoDelay());
}

}  // namespace safety_control_cloud
