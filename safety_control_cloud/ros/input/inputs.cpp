// SPDX-License-Identifier: BSD-3-Clause
#include "inputs.hpp"

#include <image_transport/camera_common.h>
#include <image_transport/transport_hints.h>

#include "../graph/named_in.hpp"
#include "cloud_input.hpp"
#include "depth_input.hpp"
#include "scan_input.hpp"

namespace safety_control_cloud {
namespace {

constexpr char cloud_topic[] = "camera/depth/points", image_topic[] = "camera/depth/image_rect", scan_topic[] = "scan";

std::string topic_of(const SensorSettings& sensor) {
  if (!sensor.topic.empty()) return sensor.topic;
  switch (sensor.type) {
    case InputKind::Depth:
      return image_topic;
    case InputKind::Scan:
      return scan_topic;
    case InputKind::Cloud:
      break;
  }
  return cloud_topic;
}

}  // namespace

std::unique_ptr<Input> input_of(const SensorSettings& sensor, ros::NodeHandle& handle,
                                const ros::NodeHandle& private_handle, Delivery delivery, const OnArrival& on_arrival,
                                const Warn& warn) {
  const std::string topic = named_in(handle, topic_of(sensor));
  switch (sensor.type) {
    case InputKind::Depth:
      return std::make_unique<DepthInput>(handle, private_handle, topic, delivery, on_arrival, warn);
    case InputKind::Scan:
      return std::make_unique<ScanInput>(handle, topic, on_arrival);
    case InputKind::Cloud:
      break;
  }
  return std::make_unique<CloudInput>(handle, topic, delivery, on_arrival);
}

std::vector<Wanted> wanted_by(const SensorSettings& sensor, const ros::NodeHandle& handle,
                              const ros::NodeHandle& private_handle) {
  const std::string topic = handle.resolveName(named_in(handle, topic_of(sensor)));
  if (sensor.type == InputKind::Cloud) return {{topic, "sensor_msgs/PointCloud2"}};
  if (sensor.type == InputKind::Scan) return {{topic, "sensor_msgs/LaserScan"}};
  const auto transport = image_transport::TransportHints("raw", {}, private_handle).getTransport();
  const Wanted raw{topic, "sensor_msgs/Image"}, packed{topic + "/" + transport, "sensor_msgs/CompressedImage"};
  return {transport == "raw" ? raw : packed, {image_transport::getCameraInfoTopic(topic), "sensor_msgs/CameraInfo"}};
}

}  // namespace safety_control_cloud
