// SPDX-License-Identifier: BSD-3-Clause
// A camera in a process of its own, which measures the node that answers it.
#include <iostream>

#include "measurement.hpp"
#include "scene_message.hpp"
#include "serialised.hpp"

namespace safety_control_cloud {
namespace {

void run(const Plan& plan) {
  const auto publisher = ros::NodeHandle().advertise<sensor_msgs::PointCloud2>("camera/depth/points", 1);
  Serialised cloud(message_of(plan.picture), publisher);
  measure(plan, publisher, {[] {}, [&] { cloud.publish(ros::Time::now()); }});
}

}  // namespace
}  // namespace safety_control_cloud

int main(int argc, char** argv) {
  ros::init(argc, argv, "cloud_camera", ros::init_options::NoRosout);
  if (argc < 7) {
    std::cerr << "Usage: cloud_camera WIDTH HEIGHT RATE WARM_UP CLOUDS PID...\n";
    return 2;
  }
  const ros::NodeHandle keeps_the_threads_running;
  safety_control_cloud::run(safety_control_cloud::plan_of({argv + 1, argv + argc}));
}
