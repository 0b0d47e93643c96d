// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "near_ground.hpp"
#include "things_memory.hpp"

namespace safety_control_cloud {

/// What of the memory is written down, to outlive the process.
struct Kept {
  std::size_t width = 0, height = 0;  ///< of the picture in which the spots lie
  float blind_range = 0.0f;           ///< [m] learned
  std::vector<Remembered> things;
  std::vector<NearGround::Code> low;  ///< LowObstacles::floor()
  CameraPose camera{};                ///< in the latest picture
  bool more = false;                  ///< is lost than this tells of
};

/// A line of text of at most 50 kilobytes: of each thing only some spots. Empty if there is nothing to keep. Where more
/// is lost than fits into it, it says only that, and is not read again: nobody knows then where they all are.
std::string to_text(const Kept& kept);

/// Whether any is told of.
bool is_any_low(const Kept& kept);

/// What was written down; none if the text is not whole, or of another version. Nothing of it is seen now.
std::optional<Kept> kept_in(const std::string& text);

}  // namespace safety_control_cloud
