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
    int shown;   ///< the floor, or something beyond it, is seen now
    int hidden;  ///< it was seen, or something before it, and now it is not
    int foot;    ///< of the hidden ones, those that return something nearer
    int blank;   ///< return nothing, and did at some time or have such on both sides
  };

  /// Finds the floor again in the latest cloud.
  void survey(const PixelMemory& memory);

  Column column(std::size_t i) const { return {shown_[i], hidden_[i], foot_[i], blank_[i]}; }

  /// Whether what is seen near now in a pixel column reaches down to the strip without a gap: nearer, it would hide it.
  bool is_reached(const PixelMemory& memory, std::size_t column) const;

  /// Whether the strip is blank over the width of a post: something stands nearer than the camera can see.
  bool is_covered() const;

 private:
  using Count = std::uint16_t;

  std::uint16_t learned(const PixelMemory& memory, std::size_t row);
  void count_row(const PixelMemory& memory, std::size_t row);

  std::vector<std::uint16_t> lowest_;                 ///< code of the lowest ground return of each row; 0 = none
  std::size_t top_ = 0;                               ///< its highest row; behind the last if there is none
  std::vector<Count> shown_, hidden_, foot_, blank_;  ///< each beside its like: a vector unit counts several at once
};

}  // namespace safety_control_cloud
