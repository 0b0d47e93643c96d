// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "near_search.hpp"

namespace safety_control_cloud {

/// The near pixels in the corridor of some rows of a picture. Each row that shows any is a line of slots, with a pixel
/// in each or none, so that what is asked of all pixels is asked of many at a time.
struct NearPixels {
  using Index = std::uint32_t;  ///< of a slot, line by line

  // Of each slot.
  std::vector<float> ahead;           ///< [m] of the camera; NaN where there is no pixel
  std::vector<float> x, y;            ///< [m] in the corridor's axes
  std::vector<std::uint16_t> column;  ///< of the picture

  std::vector<std::size_t> rows;  ///< of each line, the picture's
  std::size_t row_step = 1;       ///< from one to the next, where it does not matter which
  std::size_t column_step = 1;
  std::size_t slots = 0;  ///< a line has

  std::size_t line_of(Index i) const { return i / slots; }
  std::size_t slot_of(Index i) const { return i % slots; }
  std::size_t row_of(Index i) const { return rows[line_of(i)]; }
  bool has_pixel(Index i) const { return ahead[i] == ahead[i]; }
};

NearPixels near_pixels(const NearSearch& search);

}  // namespace safety_control_cloud
