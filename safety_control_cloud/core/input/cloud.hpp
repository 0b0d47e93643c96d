// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace safety_control_cloud {

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;

enum class Scalar : std::uint8_t { Float32, Float64 };

/// Borrowed bytes of a cloud, and where x, y and z lie in them. Whoever makes one has checked that every point lies
/// inside the bytes (see layout.hpp), so that whoever reads one need not.
/// Optical frame: x right, y down, z forward [m].
struct CloudView {
  const std::uint8_t* bytes = nullptr;
  std::size_t width = 0;                   ///< points in a row
  std::size_t height = 0;                  ///< rows; 1 if the cloud is not organised
  std::size_t point_step = 0;              ///< [byte] from one point to the next
  std::size_t row_step = 0;                ///< [byte] from one row to the next
  std::array<std::size_t, 3> offset = {};  ///< [byte] of x, y, z in a point; need not be aligned
  Scalar scalar = Scalar::Float32;
  bool swapped = false;  ///< the byte order is not this machine's

  std::size_t size() const { return width * height; }
  bool is_of_floats() const { return scalar == Scalar::Float32 && !swapped; }  ///< of this machine
  bool y_and_z_follow_x() const {
    return offset[1] == offset[0] + sizeof(float) && offset[2] == offset[1] + sizeof(float);
  }
};

/// Of points that begin with x, y and z, in rows of so many. They are borrowed.
template <std::size_t values>
CloudView in_rows(const std::vector<std::array<float, values>>& points, std::size_t width) {
  CloudView view;
  view.bytes = reinterpret_cast<const std::uint8_t*>(points.data());
  view.width = width;
  view.height = width == 0 ? 0 : points.size() / width;
  view.point_step = sizeof(points[0]);
  view.row_step = width * view.point_step;
  view.offset = {0, sizeof(float), 2 * sizeof(float)};
  return view;
}

}  // namespace safety_control_cloud
