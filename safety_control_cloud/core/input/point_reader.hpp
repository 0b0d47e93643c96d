// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "view.hpp"

namespace safety_control_cloud {

/// Reads a T that lies anywhere, in either byte order.
template <class T, bool Swapped>
T read_value(const std::uint8_t* from) {
  std::uint8_t raw[sizeof(T)];
  std::memcpy(raw, from, sizeof(T));
  if constexpr (Swapped) std::reverse(raw, raw + sizeof(T));
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// A double as float32 that keeps what it is: a finite number stays finite, so that no far point becomes an infinity,
/// which would mean "too close" (REP 117) or nothing.
inline float narrowed(double value) {
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::isfinite(value) ? std::clamp(value, -largest, largest) : value);
}
inline float narrowed(float value) { return value; }

/// A pixel's depth; NaN where nothing was measured.
inline float measured(std::uint16_t pixel) { return pixel == 0 ? std::numeric_limits<float>::quiet_NaN() : pixel; }
inline float measured(float pixel) { return std::isfinite(pixel) ? pixel : std::numeric_limits<float>::quiet_NaN(); }

/// Calls visit(x, y, z) for the point in a row and column of a cloud.
template <class T, bool Swapped>
struct CloudReader {
  CloudView cloud;

  template <class Visit>
  void operator()(std::size_t row, std::size_t column, Visit& visit) const {
    const std::uint8_t* point = cloud.bytes + row * cloud.row_step + column * cloud.point_step;
    const auto coordinate = [&](std::size_t offset) { return narrowed(read_value<T, Swapped>(point + offset)); };
    visit(coordinate(cloud.offset[0]), coordinate(cloud.offset[1]), coordinate(cloud.offset[2]));
  }
};

/// The same of a depth image.
template <class T, bool Swapped>
struct DepthReader {
  DepthView view;
  Rays rays;

  explicit DepthReader(const DepthView& image) : view(image), rays(image) {}

  /// Its point keeps a z of -Inf, as that of a cloud would.
  bool is_too_close(T pixel) const {
    return view.minus_inf == MinusInf::TooClose && pixel == -std::numeric_limits<T>::infinity() &&
           std::numeric_limits<T>::has_infinity;
  }

  template <class Visit>
  void operator()(std::size_t row, std::size_t column, Visit& visit) const {
    const std::uint8_t* pixel = view.bytes + row * view.row_step + column * sizeof(T);
    const T stored = read_value<T, Swapped>(pixel);
    const float depth = is_too_close(stored) ? static_cast<float>(stored) : measured(stored);
    const auto u = static_cast<float>(view.first_column + column), v = static_cast<float>(view.first_row + row);
    visit((u - rays.cx) * depth * rays.x_scale, (v - rays.cy) * depth * rays.y_scale, depth * rays.z_scale);
  }
};

/// Calls use(reader) with the reader for the view's layout, so that the layout is decided once, outside the loop.
template <class Use>
void with_reader(const CloudView& cloud, Use use) {
  if (cloud.scalar == Scalar::Float64) {
    cloud.swapped ? use(CloudReader<double, true>{cloud}) : use(CloudReader<double, false>{cloud});
  } else {
    cloud.swapped ? use(CloudReader<float, true>{cloud}) : use(CloudReader<float, false>{cloud});
  }
}

template <class Use>
void with_reader(const DepthView& image, Use use) {
  if (image.depth == Depth::Metres) {
    image.swapped ? use(DepthReader<float, true>(image)) : use(DepthReader<float, false>(image));
  } else {
    image.swapped ? use(DepthReader<std::uint16_t, true>(image)) : use(DepthReader<std::uint16_t, false>(image));
  }
}

template <class Use>
void with_reader(const View& view, Use use) {
  std::visit([&](const auto& points) { with_reader(points, use); }, view);
}

/// Calls visit(x, y, z) for every point, row by row.
template <class Visit>
void for_each_point(const View& view, Visit visit) {
  const std::size_t width = width_of(view), height = width == 0 ? 0 : height_of(view);  // however many empty rows
  with_reader(view, [&](auto reader) {
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t column = 0; column < width; ++column) reader(row, column, visit);
    }
  });
}

}  // namespace safety_control_cloud
