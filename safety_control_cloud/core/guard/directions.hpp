// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "../path/outline.hpp"
#include "guard.hpp"

namespace safety_control_cloud {

/// A simple motion, and its bit in SafetyState.open.
struct Direction {
  std::uint8_t bit;
  const char* name;
  Twist2 twist;  ///< of 1 m/s or 1 rad/s
};

constexpr std::array<Direction, 6> directions = {{{1, "forward", {1, 0, 0}},
                                                  {2, "backward", {-1, 0, 0}},
                                                  {4, "left", {0, 1, 0}},
                                                  {8, "right", {0, -1, 0}},
                                                  {16, "turning left", {0, 0, 1}},
                                                  {32, "turning right", {0, 0, -1}}}};

/// The motion at which the fastest point of the footprint has this speed [m/s].
inline Twist2 at_speed(const Outline& outline, const Direction& direction, double speed) {
  return limited(direction.twist, speed / fastest_point(outline, direction.twist));
}

/// Bits of those in which a robot that stands may move: at escape_speed, or min_speed where that is more.
std::uint8_t open_directions(const Guard& guard, const GuardSettings& settings, const UnderWay& under_way,
                             const std::vector<Known>& known);

}  // namespace safety_control_cloud
