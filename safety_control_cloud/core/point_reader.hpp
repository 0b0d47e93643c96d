// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
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

template <class T, bool Swapped, class Visit>
void for_each_point_of(const CloudView& view, Visit& visit) {
  for (std::size_t row = 0; row < view.height; ++row) {
    const std::uint8_t* at = view.bytes + row * view.row_step;
    for (std::size_t column = 0; column < view.width; ++column, at += view.point_step) {
      visit(read_coordinate<T, Swapped>(at + view.offset[0]), read_coordinate<T, Swapped>(at + view.offset[1]),
            read_coordinate<T, Swapped>(at + view.offset[2]));
    }
  }
}

/// Calls visit(x, y, z) for every point, row by row. The layout is decided once, outside the loop.
template <class Visit>
void for_each_point(const CloudView& view, Visit visit) {
  if (view.scalar == Scalar::Float64) {
    view.swapped ? for_each_point_of<double, true>(view, visit) : for_each_point_of<double, false>(view, visit);
  } else {
    view.swapped ? for_each_point_of<float, true>(view, visit) : for_each_point_of<float, false>(view, visit);
  }
}

}  // namespace safety_control_cloud
