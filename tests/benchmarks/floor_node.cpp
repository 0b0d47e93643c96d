// SPDX-License-Identifier: BSD-3-Clause
// The least that a node in a process of its own can do: receives the cloud, looks at nothing, answers with a Twist.
// With the argument `depth`: a depth image, and the CameraInfo that comes with each. With `guard`: two clouds and a
// scan, and answers each command with itself.
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <functional>
#include <string>
#include <vector>

#include "../../safety_control_cloud/ros/input/receive_memory.hpp"
#include "../../safety_control_cloud/ros/input/received.hpp"

namespace {

/// Leaves the bytes unread, in the buffer that they arrived in.
template <class Message>
ros::Subscriber hear(ros::NodeHandle& handle, const std::string& topic, const std::function<void()>& answer) {
  return safety_control_cloud::subscribe_received<Message>(handle, topic, [=](auto&, const std::string&) { answer(); });
}

}  // namespace

int main(int argc, char** argv) {
  safety_control_cloud::keep_memory_for_reuse();
  ros::init(argc, argv, "floor_node");
  ros::NodeHandle handle;
  const auto command = handle.advertise<geometry_msgs::Twist>("cmd_vel_mux/input/teleop", 1);
  const auto answer = [&] { command.publish(geometry_msgs::Twist()); };
  std::vector<ros::Subscriber> inputs;
  ros::Publisher passed;
  if (argc == 2 && argv[1] == std::string("guard")) {
    passed = handle.advertise<geometry_msgs::Twist>("cmd_vel", 1);
    const auto pass = [&](const geometry_msgs::Twist::ConstPtr& wish) { passed.publish(wish); };
    inputs.push_back(hear<sensor_msgs::PointCloud2>(handle, "front/points", [] {}));
    inputs.push_back(hear<sensor_msgs::PointCloud2>(handle, "rear/points", [] {}));
    inputs.push_back(hear<sensor_msgs::LaserScan>(handle, "scan", [] {}));
    inputs.push_back(handle.subscribe<geometry_msgs::Twist>(
        "cmd_vel_in", 1, boost::function<void(const geometry_msgs::Twist::ConstPtr&)>(pass), nullptr,
        ros::TransportHints().tcpNoDelay()));
  } else if (argc == 2 && argv[1] == std::string("depth")) {
    inputs.push_back(hear<sensor_msgs::CameraInfo>(handle, "camera/depth/camera_info", [] {}));
    inputs.push_back(hear<sensor_msgs::Image>(handle, "camera/depth/image_rect", answer));
  } else {
    inputs.push_back(hear<sensor_msgs::PointCloud2>(handle, "camera/depth/points", answer));
  }
  ros::spin();
}
