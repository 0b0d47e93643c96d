// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pixel_memory.hpp"

namespace safety_control_cloud {

/// The near floor, in the lowest rows of an organised cloud: what stands in a pixel column nearer than it hides it.
/// It is found in the memory itself: rows, from the lowest up, with near returns below the corridor. How low the floor
/// lies in a row is the lowest such return, soon forgotten where none lies as low again: one bump of the robot must not
/// make feet of the floor. What lies clearly higher is the foot of something. A row in which all lie higher than the
/// floor of another shows feet alone: the strip ends there.
class FloorStrip {
 public:
  /// Of one pixel column, the pixels of the strip.
  struct Column {
    std::uint16_t shown = 0;   ///< the floor, or something beyond it, is seen now
    std::uint16_t hidden = 0;  ///< it was seen, or something before it, and now it is not
    std::uint16_t foot = 0;    ///< of the hidden ones, those that return something nearer
    std::uint16_t blank = 0;   ///< return nothing, and did at some time or have such on both sides
  };

  /// Finds the floor again in the latest cloud.
  void survey(const PixelMemory& memory);

  const std::vector<Column>& columns() const { return columns_; }

  /// Whether what is seen near now in a pixel column reaches down to the strip without a gap: nearer, it would hide it.
  bool is_reached(const PixelMemory& memory, std::size_t column) const;

  /// Whether the strip is blank over the width of a post: something stands nearer than the camera can see.
  bool is_covered() const;

 private:
  std::uint16_t learned(const PixelMemory& memory, std::size_t row);
  void count_row(const PixelMemory& memory, std::size_t row);

  std::vector<std::uint16_t> lowest_;  ///< code of the lowest ground return of each row; 0 = none
  std::size_t top_ = 0;                ///< its highest row; behind the last if there is none
  std::vector<Column> columns_;
};

}  // namespace safety_control_cloud
