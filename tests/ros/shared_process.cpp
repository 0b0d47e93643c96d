// SPDX-License-Identifier: BSD-3-Clause
// The node in a process with others, on a queue that they use too, as a nodelet in its manager:
// /block [s] keeps that queue's only thread busy, /talk [m/s] commands the robot from within the process.
#include <geometry_msgs/Twist.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Float64.h>

#include <thread>

#include "../../safety_control_cloud/ros/command/last_word.hpp"
#include "../../safety_control_cloud/ros/nodes.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "safety_control_cloud");
  ros::NodeHandle handle;
  ros::CallbackQueue shared;
  ros::NodeHandle of_node, private_of_node("~");
  of_node.setCallbackQueue(&shared);
  private_of_node.setCallbackQueue(&shared);
  const auto node = safety_control_cloud::node_of(of_node, private_of_node, safety_control_cloud::Delivery::Shared);
  const safety_control_cloud::LastWord last_word([&] { node->end(); });

  using Number = std_msgs::Float64::ConstPtr;
  const auto block = of_node.subscribe<std_msgs::Float64>(
      "/block", 1,
      boost::function<void(const Number&)>([](const Number& time) { ros::WallDuration(time->data).sleep(); }));
  const auto publisher = handle.advertise<geometry_msgs::Twist>("cmd_vel_mux/input/teleop", 1);
  const auto talk =
      handle.subscribe<std_msgs::Float64>("/talk", 1, boost::function<void(const Number&)>([&](const Number& speed) {
                                            geometry_msgs::Twist command;
                                            command.linear.x = speed->data;
                                            publisher.publish(command);
                                          }));

  std::thread worker([&] {
    while (ros::ok()) shared.callAvailable(ros::WallDuration(0.05));
  });
  ros::spin();
  worker.join();
}
