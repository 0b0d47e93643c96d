// SPDX-License-Identifier: BSD-3-Clause
// A camera that sends depth images in a process of its own, and measures what answers them.
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include "measurement.hpp"
#include "serialised.hpp"

namespace safety_control_cloud {
namespace {

constexpr char frame[] = "camera_depth_optical_frame";

sensor_msgs::Image image_of(CameraPicture picture) {
  picture.point_step = sizeof(float);  // no cloud then, but depths in metres
  sensor_msgs::Image image;
  image.header.frame_id = frame;
  image.width = static_cast<std::uint32_t>(picture.width);
  image.height = static_cast<std::uint32_t>(picture.height);
  image.encoding = "32FC1";
  image.step = image.width * static_cast<std::uint32_t>(picture.point_step);
  image.data = bytes_of(picture);
  return image;
}

/// The lens that bytes_of() places its points by.
sensor_msgs::CameraInfo info_of(const CameraPicture& picture) {
  sensor_msgs::CameraInfo info;
  info.header.frame_id = frame;
  info.width = static_cast<std::uint32_t>(picture.width);
  info.height = static_cast<std::uint32_t>(picture.height);
  const double focal = picture.focal(), u = 0.5 * info.width, v = 0.5 * info.height;
  info.distortion_model = "plumb_bob";
  info.D.assign(5, 0.0);
  info.K = {focal, 0.0, u, 0.0, focal, v, 0.0, 0.0, 1.0};
  info.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  info.P = {focal, 0.0, u, 0.0, 0.0, focal, v, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

void run(const Plan& plan) {
  ros::NodeHandle handle("camera/depth");
  const auto images = handle.advertise<sensor_msgs::Image>("image_rect", 1);
  const auto infos = handle.advertise<sensor_msgs::CameraInfo>("camera_info", 1);
  Serialised image(image_of(plan.picture), images), info(info_of(plan.picture), infos);
  const auto publish = [&] {
    const ros::Time now = ros::Time::now();
    info.publish(now);
    image.publish(now);
  };
  // The first image without its CameraInfo would wait for an answer in vain.
  const auto meet_infos = [&] {
    while (infos.getNumSubscribers() == 0 && ros::ok()) ros::WallDuration(0.001).sleep();
  };
  measure(plan, images, {meet_infos, publish});
}

}  // namespace
}  // namespace safety_control_cloud

int main(int argc, char** argv) {
  return safety_control_cloud::run_camera(argc, argv, "depth_camera", safety_control_cloud::run);
}
