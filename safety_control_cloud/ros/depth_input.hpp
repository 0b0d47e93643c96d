// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <image_transport/subscriber_filter.h>
#include <message_filters/subscriber.h>
#include <message_filters/time_synchronizer.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <string>

#include "arrival.hpp"

namespace safety_control_cloud {

/// Depth images, over any image_transport, each with the CameraInfo of its stamp from the topic `camera_info` beside
/// theirs: image_transport's CameraSubscriber, but one that knows who sent. An image without its CameraInfo is no
/// measurement and arrives nowhere; a warning says so.
class DepthInput {
 public:
  DepthInput(ros::NodeHandle& handle, const ros::NodeHandle& private_handle, const std::string& topic,
             OnArrival on_arrival);

 private:
  using Image = sensor_msgs::Image;
  using CameraInfo = sensor_msgs::CameraInfo;

  void on_image(const Image::ConstPtr&);
  void on_pair(const ros::MessageEvent<const Image>& image, const ros::MessageEvent<const CameraInfo>& camera);

  OnArrival on_arrival_;
  std::string topic_;  ///< without the transport's own name
  image_transport::ImageTransport transport_;
  image_transport::SubscriberFilter images_;
  message_filters::Subscriber<CameraInfo> cameras_;
  message_filters::TimeSynchronizer<Image, CameraInfo> pairs_;
  std::size_t images_alone_ = 0;  ///< since the latest pair
};

}  // namespace safety_control_cloud
