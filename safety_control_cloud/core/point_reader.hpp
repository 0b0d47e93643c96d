// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "cloud.hpp"

namespace safety_control_cloud {

/// A double as float32 that keeps what it is: a finite number stays finite, so that no far point becomes an infinity,
/// which would mean "too close" (REP 117) or nothing.
inline float narrowed(double value) {
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::isfinite(value) ? std::clamp(value, -largest, largest) : value);
}

/// Reads one coordinate of type T that lies anywhere, in either byte order.
template <class T, bool Swapped>
float read_coordinate(const std::uint8_t* from) {
  std::uint8_t raw[sizeof(T)];
  std::memcpy(raw, from, sizeof(T));
  if constexpr (Swapped) std::reverse(raw, raw + sizeof(T));
  T value;
  std::memcpy(&value, raw, sizeof(T));
  if constexpr (sizeof(T) == sizeof(double)) return narrowed(value);
  return static_cast<float>(value);
}

/// Calls visit(x, y, z) for the point that begins at a place in memory.
template <class T, bool Swapped>
struct PointReader {
  std::array<std::size_t, 3> offset;

  template <class Visit>
  void operator()(const std::uint8_t* point, Visit& visit) const {
    visit(read_coordinate<T, Swapped>(point + offset[0]), read_coordinate<T, Swapped>(point + offset[1]),
          read_coordinate<T, Swapped>(point + offset[2]));
  }
};

/// Calls use(reader) with the PointReader for the view's layout, so that the layout is decided once, outside the loop.
template <class Use>
void with_reader(const CloudView& view, Use use) {
  if (view.scalar == Scalar::Float64) {
    view.swapped ? use(PointReader<double, true>{view.offset}) : use(PointReader<double, false>{view.offset});
  } else {
    view.swapped ? use(PointReader<float, true>{view.offset}) : use(PointReader<float, false>{view.offset});
  }
}

/// Calls visit(x, y, z) for every point, row by row.
template <class Visit>
void for_each_point(const CloudView& view, Visit visit) {
  if (view.width == 0) return;  // however many rows of nothing there are
  with_reader(view, [&](auto reader) {
    for (std::size_t row = 0; row < view.height; ++row) {
      const std::uint8_t* at = view.bytes + row * view.row_step;
      for (std::size_t column = 0; column < view.width; ++column, at += view.point_step) reader(at, visit);
    }
  });
}

}  // namespace safety_control_cloud
