// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../input/cloud.hpp"

namespace safety_control_cloud {

/// Where directions lie in a picture made of points: x / z and y / z, in cells.
struct Grid {
  float left = -0.3f, top = -0.3f, right = 0.3f, bottom = 0.3f;  ///< slopes; grow with what is seen
  float cell = 0.01f;                                            ///< slope
  std::size_t width = 60, height = 60;

  std::ptrdiff_t column(const Point& point) const;
  std::ptrdiff_t row(const Point& point) const;
};

/// On which rays of a cloud that is not organised anything returns, finer than the cells of the picture that is made of
/// it: what is thinner than two cells leaves no hole in that picture.
class RayHits {
 public:
  /// Of these returns, which are borrowed, and are gone through when the first ray is asked about: most clouds show
  /// nothing lost, and are spared it.
  void take(const Grid& grid, const std::vector<Point>& returns);
  const Grid& grid() const { return grid_; }
  float down_in(std::size_t row) const;  ///< y / z in the middle of a row of cells
  /// Whether anything returns on a ray or right beside it, nearer than the next ray: slopes x / z and y / z.
  bool any(float right, float down) const;

 private:
  /// Of a cell, which is a little wider than points lie apart.
  static constexpr std::ptrdiff_t across = 4;

  void fill() const;

  Grid grid_;
  mutable const std::vector<Point>* pending_ = nullptr;  ///< returns that are not in the cells yet
  mutable std::vector<std::uint16_t> cells_;             ///< a bit for each part of a cell
};

}  // namespace safety_control_cloud
