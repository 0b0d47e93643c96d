// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "loss.hpp"

namespace safety_control_cloud {

/// What stands on the near floor and ends below the corridor: a kerb, a step, a shoe. Nearer, the camera looks over it,
/// so it is kept from when it is first seen until the floor before it is seen again.
///
/// In a pixel column it is a step: from the lowest pixel up, the near ground rises at once. Both are seen in one cloud,
/// so that neither a slope nor a bump of the robot looks like one. Where something near is seen in the corridor too,
/// the step is the foot of that, and its distance decides.
class LowObstacles {
 public:
  /// The nearest in the latest cloud, if one is at least as wide as a thin post. It is lost as a whole, or about to be,
  /// if it is so near that the floor before it is not seen any more.
  std::optional<Loss> judge(const PixelMemory& memory, const View& view, const Gaze& gaze);

 private:
  using Millimetres = std::int16_t;  // every vector unit compares these fastest

  struct Pixel {
    std::size_t row, column;
  };

  void survey(const PixelMemory& memory);
  bool look_at_row(const std::uint16_t* pixels);
  bool is_step(std::size_t column) const { return floor_[column] > 0; }
  bool hides_floor(std::size_t column) const;
  /// Of each column that shows a step, the lowest pixel on it.
  std::vector<Pixel> pixels(const PixelMemory& memory) const;

  // Of each column, below the camera.
  std::vector<Millimetres> floor_;   ///< before the step; 0 if there is no step
  std::vector<Millimetres> lowest_;  ///< the near ground that the lowest pixel of it shows now
  std::vector<std::int16_t> above_;  ///< pixels that show ground a step above `lowest_`
};

}  // namespace safety_control_cloud
