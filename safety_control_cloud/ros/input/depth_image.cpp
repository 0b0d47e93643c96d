// SPDX-License-Identifier: BSD-3-Clause
#include "depth_image.hpp"

#include <algorithm>
#include <exception>

namespace safety_control_cloud {
namespace {

using ros::serialization::IStream;

CameraClaims claims_of(const sensor_msgs::CameraInfo& camera) {
  CameraClaims claims;
  claims.height = camera.height;
  claims.width = camera.width;
  claims.D = camera.D;
  std::copy(camera.K.begin(), camera.K.end(), claims.K.begin());
  std::copy(camera.P.begin(), camera.P.end(), claims.P.begin());
  claims.binning_x = camera.binning_x;
  claims.binning_y = camera.binning_y;
  claims.roi = {camera.roi.x_offset, camera.roi.y_offset, camera.roi.height, camera.roi.width};
  return claims;
}

/// sensor_msgs/Image after its header, in the order of its definition.
void read_contents(IStream& stream, DepthImage& image) {
  std::uint8_t is_bigendian;
  stream.next(image.layout.height);
  stream.next(image.layout.width);
  image.layout.encoding = text_in(stream);
  stream.next(is_bigendian);
  image.layout.is_bigendian = is_bigendian != 0;
  stream.next(image.layout.step);
  image.bytes = bytes_in(stream);
  expect_end(stream);
}

}  // namespace

DepthImage image_in(IStream& stream) {
  DepthImage image;
  try {
    read_header(stream, image.header);
    read_contents(stream, image);
  } catch (const std::exception& problem) {
    image.problem = problem.what();
  }
  return image;
}

DepthImage image_in(const sensor_msgs::Image::ConstPtr& message) {
  DepthImage image;
  image.header = message->header;
  image.layout.height = message->height;
  image.layout.width = message->width;
  image.layout.encoding = message->encoding;
  image.layout.is_bigendian = message->is_bigendian != 0;
  image.layout.step = message->step;
  image.bytes = {message->data.data(), message->data.size()};
  image.owner = message;
  return image;
}

Reading view_of(const DepthImage& image, const sensor_msgs::CameraInfo& camera, bool rectified) {
  if (!image.problem.empty()) return Unreadable{image.problem};
  DepthLayout layout = image.layout;
  layout.rectified = rectified;
  layout.camera = claims_of(camera);
  return view_of(layout, image.bytes.first, image.bytes.size);
}

}  // namespace safety_control_cloud
