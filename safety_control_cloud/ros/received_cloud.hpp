// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <sensor_msgs/PointCloud2.h>

#include "arrival.hpp"

namespace safety_control_cloud {

/// A sensor_msgs/PointCloud2 to roscpp, but one that keeps nothing: it is handed over while it is being deserialised,
/// the only moment at which roscpp shows a subscriber the buffer that it received.
struct ReceivedCloud {
  OnArrival on_arrival;
  std::string source = {};
};

/// The cloud in the bytes of one serialised sensor_msgs/PointCloud2, borrowed from them. Believes no length in them
/// before it has checked it.
Arrival arrival_in(ros::serialization::IStream& stream);

}  // namespace safety_control_cloud

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<safety_control_cloud::ReceivedCloud> : MD5Sum<sensor_msgs::PointCloud2> {};
template <>
struct DataType<safety_control_cloud::ReceivedCloud> : DataType<sensor_msgs::PointCloud2> {};

}  // namespace message_traits

namespace serialization {

template <>
struct PreDeserialize<safety_control_cloud::ReceivedCloud> {
  static void notify(const PreDeserializeParams<safety_control_cloud::ReceivedCloud>& about) {
    about.message->source = (*about.connection_header)["callerid"];
  }
};

template <>
struct Serializer<safety_control_cloud::ReceivedCloud> {
  static void read(IStream& stream, safety_control_cloud::ReceivedCloud& cloud) {
    safety_control_cloud::Arrival arrival = safety_control_cloud::arrival_in(stream);
    arrival.source = cloud.source;
    cloud.on_arrival(arrival);
  }
};

}  // namespace serialization
}  // namespace ros
