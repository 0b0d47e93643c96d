// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "near_search.hpp"

namespace safety_control_cloud {

/// A near pixel in the corridor.
struct NearPixel {
  std::uint16_t row, column;
  std::uint16_t line, slot;  ///< among the rows that were looked at, and the columns
  float x, y;                ///< [m] in the corridor's axes
  float ahead;               ///< [m] of the camera
};

/// The near pixels of some rows, row by row.
struct NearPixels {
  std::vector<NearPixel> pixels;
  std::vector<std::size_t> rows;  ///< those of them that show any
  std::size_t row_step = 1;       ///< from one to the next, where it does not matter which
  std::size_t column_step = 1;
  std::size_t slots = 0;  ///< a line has
};

NearPixels near_pixels(const NearSearch& search);

}  // namespace safety_control_cloud
