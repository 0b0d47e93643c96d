// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "../input/view.hpp"
#include "ray_samples.hpp"

namespace safety_control_cloud {

/// Which way pixels look along one axis of a picture: x/z of a column, or y/z of a row, is at_zero + slope x pixel.
struct RayLine {
  double at_zero, slope;

  double slant(double pixel) const { return at_zero + slope * pixel; }
  double pixel(double slant) const { return (slant - at_zero) / slope; }
};

struct RayLines {
  std::optional<RayLine> across, down;  ///< over the columns, and over the rows; none: not known
};

/// Of a picture narrower than this on a side [slope] nothing is known: 1.7 degrees.
constexpr double narrowest_picture = 0.03;

/// Of some of its pixels, by medians, which a quarter of odd rays does not move; none where there are too few.
RayLines lines_along(const RaySamples& samples, std::size_t width, std::size_t height);

/// Of a depth image by its camera; of an organised cloud by its points, as far as enough of them return.
RayLines ray_lines_of(const View& view);

}  // namespace safety_control_cloud
