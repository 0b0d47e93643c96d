// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "reading.hpp"

namespace safety_control_cloud {

/// sensor_msgs/PointField: one named value in every point.
struct Field {
  static constexpr std::uint8_t FLOAT32 = 7;
  static constexpr std::uint8_t FLOAT64 = 8;

  std::string name;
  std::uint32_t offset = 0;  ///< [byte] from the start of the point
  std::uint8_t datatype = 0;
  std::uint32_t count = 1;
};

/// What a sensor_msgs/PointCloud2 claims about its bytes. Nothing in it is true until view_of() has checked it.
struct Layout {
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::vector<Field> fields;
  bool is_bigendian = false;
  std::uint32_t point_step = 0;  ///< [byte]
  std::uint32_t row_step = 0;    ///< [byte]
};

/// The points of `size` bytes at `bytes`, if the layout is free of contradiction: x, y and z once each, all float32 or
/// all float64, one value each, not overlapping, inside the point; rows inside the data; no byte missing and none over.
/// A cloud of no points is readable. The bytes are borrowed, not copied.
Reading view_of(const Layout& layout, const std::uint8_t* bytes, std::size_t size);

}  // namespace safety_control_cloud
