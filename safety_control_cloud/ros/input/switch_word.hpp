// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "../../core/guard/switches.hpp"

namespace safety_control_cloud {

/// What a message says of a switch.
struct SwitchWord {
  std::optional<Edge> side;  ///< none: it says no side
  bool touched = false;      ///< or, of a cliff sensor, that there is no floor
};

/// Of a std_msgs/Bool, or of a Kobuki's BumperEvent or CliffEvent, whose package need not be installed: as the bytes of
/// a message of this type are. Throws std::invalid_argument, in words, of any other.
SwitchWord word_in(const std::string& type, const std::vector<std::uint8_t>& bytes);

}  // namespace safety_control_cloud
