// SPDX-License-Identifier: BSD-3-Clause
// A camera in a process of its own, which measures the node that answers it.
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
  return safety_control_cloud::run_camera(argc, argv, "cloud_camera", safety_control_cloud::run);
}
