// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <image_transport/image_transport.h>

#include <optional>
#include <string>

#include "after_others.hpp"
#include "arrival.hpp"
#include "depth_pairs.hpp"
#include "input.hpp"

namespace safety_control_cloud {

/// Depth images, over any image_transport, each with the CameraInfo of its stamp from the topic `camera_info` beside
/// theirs. An image without its CameraInfo is no measurement and arrives nowhere; a warning says so.
class DepthInput : public Input {
 public:
  DepthInput(ros::NodeHandle& handle, const ros::NodeHandle& private_handle, const std::string& topic,
             Delivery delivery, OnArrival on_arrival, Warn warn);

 private:
  void take_in_place(ros::NodeHandle& handle, const std::string& topic);
  void take_by_transport(ros::NodeHandle& handle, const std::string& topic,
                         const image_transport::TransportHints& hints);
  void on_image(const DepthImage& image);
  void on_pair(const DepthImage& image, const CameraEvent& camera);

  OnArrival on_arrival_;
  Warn warn_;
  std::string topic_;  ///< without the transport's own name
  DepthPairs pairs_;
  AfterOthers after_cameras_;
  ros::Subscriber cameras_, received_;
  std::optional<image_transport::ImageTransport> transport_;  ///< with its subscriber, in place of received_
  image_transport::Subscriber transported_;
  std::size_t images_alone_ = 0;  ///< since the latest pair
  ros::SteadyTime warned_;
};

}  // namespace safety_control_cloud
