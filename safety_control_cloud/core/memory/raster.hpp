// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "../input/view.hpp"
#include "../look/corridor.hpp"

namespace safety_control_cloud {

/// Where directions lie in a picture made of points: x / z and y / z, in cells.
struct Grid {
  float left = -0.3f, top = -0.3f, right = 0.3f, bottom = 0.3f;  ///< slopes; grow with what is seen
  float cell = 0.01f;                                            ///< slope
  std::size_t width = 60, height = 60;

  bool operator==(const Grid& other) const {
    return cell == other.cell && left == other.left && top == other.top && width == other.width &&
           height == other.height;
  }
  std::ptrdiff_t column(const Point& point) const;
  std::ptrdiff_t row(const Point& point) const;
};

/// Makes a picture of a cloud that is not organised, as a pinhole camera at the cloud's origin would see it: each cell
/// holds the nearest return in it. A cell is a little wider than the points lie apart, so that a surface leaves no
/// holes; how far that is, the cloud says itself.
class Raster {
 public:
  /// The picture of these points, as far as they are returns; valid until the next one.
  View picture_of(const View& points, const Corridor& corridor);

  std::size_t filled() const { return filled_; }  ///< cells that hold a return
  const Grid& grid() const { return grid_; }

 private:
  void fit(const std::vector<Point>& returns);

  Grid grid_;
  std::size_t filled_ = 0;
  std::vector<Point> returns_;
  std::vector<std::array<float, 3>> cells_;
};

}  // namespace safety_control_cloud
