// SPDX-License-Identifier: BSD-3-Clause
// The tutorial's node as a student writes it: what ours is compared with.
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>

#include "tutorial.hpp"

namespace {

double speed_at(float nearest) {
  if (nearest > 1.0f) return 0.2;
  if (nearest > 0.5f) return 0.1;
  return 0.0;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "tutorial_node");
  ros::NodeHandle handle;
  const auto command = handle.advertise<geometry_msgs::Twist>("cmd_vel_mux/input/teleop", 1);
  const auto output = handle.advertise<sensor_msgs::PointCloud2>("output", 1);
  const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_cloud = [&](const auto& cloud) {
    const auto seen = safety_control_cloud::tutorial(*cloud);
    geometry_msgs::Twist twist;
    twist.linear.x = speed_at(seen.nearest);
    command.publish(twist);
    output.publish(seen.crop);
  };
  const auto clouds = handle.subscribe<sensor_msgs::PointCloud2>("camera/depth/points", 1, on_cloud);
  ros::spin();
}
