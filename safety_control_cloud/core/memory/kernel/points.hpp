// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "../../look/placement.hpp"

/// Points as a cloud stores them, read and placed many at a time, in the vectors of the best instruction set of the
/// machine; the same in all of them.
namespace safety_control_cloud::points {

/// Some pixels of a row [m].
struct PixelsOfRow {
  const float *x, *y, *z;
  std::size_t size;
};

/// Points of a cloud, as many [byte] apart, whose x, y and z follow one another as floats of this machine.
struct StoredPoints {
  const std::uint8_t* first;
  std::size_t apart, size;
};

/// Into x, y and z [0 ... size - 1]. Behind the last of them nothing is read.
void read(const StoredPoints& points, float* x, float* y, float* z);

/// 3 x 3 pixels of a cloud that are stored so, by the upper left one and how far the rows are apart [byte].
struct StoredAround {
  const std::uint8_t* first;
  std::size_t apart, rows_apart;
};

/// z of each, row by row [m]; NaN where nothing returns, or nothing farther than `range_min` [m]. It may read a float
/// behind the last.
std::array<float, 9> around(const StoredAround& pixels, float range_min);

/// Takes pixels of the cloud's frame to the corridor's axes; z is NaN where nothing returns, or nothing farther than
/// `range_min` [m].
void place(const PixelsOfRow& pixels, float range_min, const std::optional<Placement>& placement, float* x, float* y,
           float* z);

/// How far the nearest of some points is from another one; `most` if they are farther away [m2].
float least_square(const PixelsOfRow& points, const Point& from, float most);

}  // namespace safety_control_cloud::points
