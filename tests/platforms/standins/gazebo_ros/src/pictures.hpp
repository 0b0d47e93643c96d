// SPDX-License-Identifier: BSD-3-Clause
// A depth camera's pictures as ROS messages.
#pragma once

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

namespace standin {

struct Lens {
  unsigned width = 0, height = 0;  // [px]
  double view = 0;                 // [rad] across

  double focal() const { return width / 2.0 / std::tan(view / 2); }  // [px]
  double column() const { return (width - 1) / 2.0; }                // [px] of the axis
  double row() const { return (height - 1) / 2.0; }
};

inline sensor_msgs::CameraInfo to_info(const std_msgs::Header& header, const Lens& lens) {
  sensor_msgs::CameraInfo info;
  info.header = header;
  info.width = lens.width;
  info.height = lens.height;
  info.distortion_model = "plumb_bob";
  info.D.assign(5, 0.0);
  info.K = {lens.focal(), 0, lens.column(), 0, lens.focal(), lens.row(), 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {lens.focal(), 0, lens.column(), 0, 0, lens.focal(), lens.row(), 0, 0, 0, 1, 0};
  return info;
}

template <typename Pixel>
sensor_msgs::Image to_image(const std_msgs::Header& header, const Lens& lens, const char* encoding, const Pixel* pixels,
                            unsigned channels) {
  sensor_msgs::Image image;
  image.header = header;
  image.width = lens.width;
  image.height = lens.height;
  image.encoding = encoding;
  image.step = static_cast<uint32_t>(lens.width * channels * sizeof(Pixel));
  image.data.resize(static_cast<size_t>(image.step) * lens.height);
  std::memcpy(image.data.data(), pixels, image.data.size());
  return image;
}

inline sensor_msgs::Image to_image(const std_msgs::Header& header, const Lens& lens, const unsigned char* rgb) {
  return to_image(header, lens, "rgb8", rgb, 3);
}

inline sensor_msgs::Image to_depth_image(const std_msgs::Header& header, const Lens& lens, const std::vector<float>& metres,
                                         bool in_millimetres) {
  if (!in_millimetres) return to_image(header, lens, "32FC1", metres.data(), 1);
  std::vector<uint16_t> millimetres;
  millimetres.reserve(metres.size());
  for (const float metre : metres) millimetres.push_back(std::isnan(metre) ? 0 : static_cast<uint16_t>(std::lround(1000 * metre)));
  return to_image(header, lens, "16UC1", millimetres.data(), 1);
}

/// Organised, 32 bytes a point; a pixel without a return is NaN in x, y and z.
inline sensor_msgs::PointCloud2 to_cloud(const std_msgs::Header& header, const Lens& lens, const std::vector<float>& metres,
                                         const unsigned char* rgb) {
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(2, "xyz", "rgb");
  modifier.resize(metres.size());
  cloud.header = header;
  cloud.width = lens.width;
  cloud.height = lens.height;
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.is_dense = false;
  sensor_msgs::PointCloud2Iterator<float> point(cloud, "x");
  sensor_msgs::PointCloud2Iterator<uint8_t> colour(cloud, "rgb");  // blue, green, red
  for (size_t pixel = 0; pixel < metres.size(); ++pixel, ++point, ++colour) {
    const float z = metres[pixel];
    point[0] = z * static_cast<float>((pixel % lens.width - lens.column()) / lens.focal());
    point[1] = z * static_cast<float>((static_cast<double>(pixel / lens.width) - lens.row()) / lens.focal());
    point[2] = z;
    for (size_t channel = 0; channel < 3; ++channel) colour[channel] = rgb[3 * pixel + 2 - channel];
  }
  return cloud;
}

}  // namespace standin
