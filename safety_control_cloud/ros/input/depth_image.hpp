// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialization.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <string>

#include "../../core/input/depth_layout.hpp"
#include "wire.hpp"

namespace safety_control_cloud {

/// A sensor_msgs/Image without its CameraInfo, from wherever its bytes lie.
struct DepthImage {
  std_msgs::Header header;  ///< as far as it could be read
  DepthLayout layout;       ///< what the image claims; nothing of its camera
  Bytes bytes;
  boost::shared_ptr<const void> owner;  ///< of the bytes; none if they are only borrowed for the length of a call
  std::string source;                   ///< the publisher's name, if it is known
  std::string problem;                  ///< why the message ends before its contents, or goes on; empty if it does not
};

/// The image in the bytes of one serialised sensor_msgs/Image, borrowed from them.
DepthImage image_in(ros::serialization::IStream& stream);

/// The same of a message, which it keeps.
DepthImage image_in(const sensor_msgs::Image::ConstPtr& message);

/// The depths of an image, borrowed from it, or why they cannot be read. `rectified` as in DepthLayout.
Reading view_of(const DepthImage& image, const sensor_msgs::CameraInfo& camera, bool rectified);

}  // namespace safety_control_cloud
