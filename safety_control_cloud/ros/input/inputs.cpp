// SPDX-License-Identifier: BSD-3-Clause
#include "inputs.hpp"

#include <image_transport/camera_common.h>
#include <image_transport/transport_hints.h>

#include "cloud_input.hpp"
#include "depth_input.hpp"

namespace safety_control_cloud {
namespace {

constexpr char cloud_topic[] = "camera/depth/points", image_topic[] = "camera/depth/image_rect";

}  // namespace

std::unique_ptr<Input> input_of(InputKind kind, ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                                Delivery delivery, const OnArrival& on_arrival, const Warn& warn) {
  if (kind == InputKind::Depth) {
    return std::make_unique<DepthInput>(handle, private_handle, image_topic, delivery, on_arrival, warn);
  }
  return std::make_unique<CloudInput>(handle, cloud_topic, delivery, on_arrival);
}

std::vector<Wanted> wanted_by(InputKind kind, const ros::NodeHandle& handle, const ros::NodeHandle& private_handle) {
  if (kind == InputKind::Cloud) return {{handle.resolveName(cloud_topic), "sensor_msgs/PointCloud2"}};
  const std::string image = handle.resolveName(image_topic);
  const auto transport = image_transport::TransportHints("raw", {}, private_handle).getTransport();
  const Wanted raw{image, "sensor_msgs/Image"}, packed{image + "/" + transport, "sensor_msgs/CompressedImage"};
  return {transport == "raw" ? raw : packed, {image_transport::getCameraInfoTopic(image), "sensor_msgs/CameraInfo"}};
}

}  // namespace safety_control_cloud
