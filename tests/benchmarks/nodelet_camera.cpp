// SPDX-License-Identifier: BSD-3-Clause
// A nodelet manager with our nodelet in it, and a camera in the same process: clouds are handed over, not sent.
#include <nodelet/loader.h>

#include <boost/make_shared.hpp>

#include "measurement.hpp"
#include "scene_message.hpp"

namespace safety_control_cloud {
namespace {

void run(const Plan& plan) {
  nodelet::Loader manager;  // what the program `nodelet manager` consists of
  if (!manager.load("/safety_control_cloud", "safety_control_cloud/SafetyControlNodelet", {}, {})) {
    throw std::runtime_error("the nodelet could not be loaded");
  }
  const auto publisher = ros::NodeHandle().advertise<sensor_msgs::PointCloud2>("camera/depth/points", 1);
  const auto scene = message_of(plan.picture);
  sensor_msgs::PointCloud2::Ptr next;
  const auto prepare = [&] { next = boost::make_shared<sensor_msgs::PointCloud2>(scene); };
  const auto publish = [&] {
    next->header.stamp = ros::Time::now();
    publisher.publish(next);
  };
  measure(plan, publisher, {prepare, publish});
}

}  // namespace
}  // namespace safety_control_cloud

int main(int argc, char** argv) {
  // The nodelet's name, so that _parameter:=value is the nodelet's.
  return safety_control_cloud::run_camera(argc, argv, "safety_control_cloud", safety_control_cloud::run);
}
