// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pixel_memory.hpp"

namespace safety_control_cloud {

/// The near floor, in the lowest rows of an organised cloud: what stands in a pixel column nearer than it hides it.
/// It is found in the memory itself: rows, from the lowest up, with near returns below the corridor. How far the floor
/// lies in a row is the farthest such return; what lies clearly nearer is the foot of something.
class FloorStrip {
 public:
  /// Of one pixel column, the pixels of the strip that returned at some time.
  struct Column {
    std::uint16_t shown = 0;   ///< the floor, or something beyond it, is seen now
    std::uint16_t hidden = 0;  ///< it is not
    std::uint16_t blank = 0;   ///< of the hidden ones, those that return nothing
  };

  /// Finds the floor again in the latest cloud.
  void survey(const PixelMemory& memory);

  const std::vector<Column>& columns() const { return columns_; }

  /// Whether the strip is blank over the width of a post: something stands nearer than the camera can see.
  bool is_covered() const;

 private:
  bool learn_row(const PixelMemory& memory, std::size_t row);
  void count_row(const PixelMemory& memory, std::size_t row);

  std::vector<std::uint16_t> farthest_;  ///< code of the farthest ground return of each row; 0 = none
  std::vector<Column> columns_;
};

}  // namespace safety_control_cloud
