// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "floor_strip.hpp"
#include "loss.hpp"
#include "pixel_memory.hpp"

namespace safety_control_cloud {

/// The pixels of an organised cloud that have lost something near, and which of them the floor speaks for.
class LostPixels {
 public:
  /// Lets go what hid the floor where that is seen again. How many pixels are lost all the same.
  std::size_t forgive(PixelMemory& memory, const FloorStrip& floor, const Sight& sight);

  /// The obstacle that so many lost pixels show, if it was nearer than `near_distance` [m].
  std::optional<Loss> judge(const PixelMemory& memory, std::size_t lost, std::size_t total, double near_distance) const;

 private:
  void note_what_hides_floor(const PixelMemory& memory, const FloorStrip& floor);
  std::vector<std::size_t> columns_with_floor_again(const PixelMemory& memory, const FloorStrip& floor);

  std::vector<bool> hid_floor_;  ///< of each column: what was last seen near in it stood on the floor
};

}  // namespace safety_control_cloud
