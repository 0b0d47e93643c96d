// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "../input/view.hpp"

namespace safety_control_cloud {

/// Where the point of a pixel lies as seen from the camera.
struct Ray {
  double column, row;
  double x, y;  ///< over z
};

/// The rays of some pixels, spread evenly over the picture.
struct RaySamples {
  static constexpr std::size_t columns = 16, rows = 12;

  std::array<std::vector<Ray>, rows> in_row;
  std::array<std::vector<Ray>, columns> in_column;
  std::size_t ahead = 0;   ///< with z > 0
  std::size_t behind = 0;  ///< measured where no camera sees: z <= 0, and not (0, 0, 0), which is nothing

  explicit RaySamples(const View& view);
};

}  // namespace safety_control_cloud
