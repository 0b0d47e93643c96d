// SPDX-License-Identifier: BSD-3-Clause
// The least that a node in a process of its own can do: receives the cloud, looks at nothing, answers with a Twist.
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include "../../safety_control_cloud/ros/receive_memory.hpp"

namespace {

/// A PointCloud2 to its publisher; here its bytes stay in the buffer that they arrived in.
struct UnreadCloud {};

}  // namespace

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<UnreadCloud> : MD5Sum<sensor_msgs::PointCloud2> {};
template <>
struct DataType<UnreadCloud> : DataType<sensor_msgs::PointCloud2> {};
template <>
struct Definition<UnreadCloud> : Definition<sensor_msgs::PointCloud2> {};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<UnreadCloud> {
  static void read(IStream& stream, UnreadCloud&) { stream.advance(stream.getLength()); }
};

}  // namespace serialization
}  // namespace ros

int main(int argc, char** argv) {
  safety_control_cloud::keep_memory_for_reuse();
  ros::init(argc, argv, "floor_node");
  ros::NodeHandle handle;
  const auto command = handle.advertise<geometry_msgs::Twist>("cmd_vel_mux/input/teleop", 1);
  const boost::function<void(const boost::shared_ptr<const UnreadCloud>&)> on_cloud = [&](const auto&) {
    command.publish(geometry_msgs::Twist());
  };
  const auto hints = ros::TransportHints().tcpNoDelay();
  const auto clouds = handle.subscribe<UnreadCloud>("camera/depth/points", 1, on_cloud, ros::VoidConstPtr(), hints);
  ros::spin();
}
