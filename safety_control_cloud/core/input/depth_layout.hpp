// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "reading.hpp"

namespace safety_control_cloud {

/// sensor_msgs/CameraInfo, with its names: what the camera claims of its images.
struct CameraClaims {
  std::uint32_t height = 0;     ///< [px] of the whole image, before binning
  std::uint32_t width = 0;      ///< the same
  std::vector<double> D;        ///< distortion; of the raw image, also where a rectified one came with it
  std::array<double, 9> K{};    ///< of the raw image; K[0] is 0 if the camera was never calibrated
  std::array<double, 12> P{};   ///< of the rectified image
  std::uint32_t binning_x = 0;  ///< 0 and 1 are the same
  std::uint32_t binning_y = 0;
  struct {
    std::uint32_t x_offset = 0, y_offset = 0, height = 0, width = 0;  ///< [px] before binning; no size: the whole image
  } roi;
};

/// What a sensor_msgs/Image of depths and its CameraInfo claim. Nothing in it is true until view_of() has checked it.
struct DepthLayout {
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string encoding;  ///< 16UC1 or 32FC1
  bool is_bigendian = false;
  std::uint32_t step = 0;  ///< [byte] from one row to the next
  bool rectified = false;  ///< the sender says that its image is, whatever the distortion of the camera
  CameraClaims camera = {};
};

/// The depths of `size` bytes at `bytes`, if the layout is free of contradiction: an encoding of depths, rows inside
/// the data, no byte missing and none over; a calibrated camera of this image's size; an image without distortion. An
/// image of no pixels is readable. The bytes are borrowed, not copied.
Reading view_of(const DepthLayout& layout, const std::uint8_t* bytes, std::size_t size);

}  // namespace safety_control_cloud
