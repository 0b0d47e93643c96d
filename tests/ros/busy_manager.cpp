// SPDX-License-Identifier: BSD-3-Clause
// A nodelet manager with /safety_control_cloud and as many other nodelets as it has workers. Each of these, on /block
// [s], says so on /busy and keeps its worker for as long.
#include <nodelet/loader.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <std_msgs/Float64.h>

#include <boost/make_shared.hpp>
#include <cstdlib>
#include <pluginlib/class_loader.hpp>
#include <string>
#include <thread>

namespace {

class Busy : public nodelet::Nodelet {
  void onInit() override {
    busy_ = getNodeHandle().advertise<std_msgs::Float64>("/busy", 100);
    block_ = getNodeHandle().subscribe("/block", 1, &Busy::on_block, this);
  }

  void on_block(const std_msgs::Float64& time) {
    busy_.publish(time);
    ros::WallDuration(time.data).sleep();
  }

  ros::Publisher busy_;
  ros::Subscriber block_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "busy_manager");
  const ros::NodeHandle keeps_the_threads_running;
  pluginlib::ClassLoader<nodelet::Nodelet> plugins("nodelet", "nodelet::Nodelet");
  nodelet::Loader manager([&](const std::string& type) {
    return type == "Busy" ? boost::make_shared<Busy>() : plugins.createInstance(type);
  });
  const unsigned workers = std::thread::hardware_concurrency();  // Loader's own choice, where it is told none
  for (unsigned i = 0; i < workers; ++i) {
    if (!manager.load("/busy_" + std::to_string(i), "Busy", {}, {})) return EXIT_FAILURE;
  }
  if (!manager.load("/safety_control_cloud", "safety_control_cloud/SafetyControlNodelet", {}, {})) return EXIT_FAILURE;
  ros::spin();
}
