// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "../path/twist.hpp"

namespace safety_control_cloud {

/// A velocity command as it comes, a geometry_msgs/Twist: more than a motion in the plane, so that it can pass as it
/// is.
struct Command {
  std::array<double, 3> linear{};   ///< [m/s] x forward, y left
  std::array<double, 3> angular{};  ///< [rad/s] about z: turning left
};

inline Twist2 in_plane(const Command& command) { return {command.linear[0], command.linear[1], command.angular[2]}; }

/// As a whole; with 1 it is equal in every bit.
inline Command scaled(Command command, double factor) {
  if (factor >= 1.0) return command;
  if (!(factor > 0.0)) return {};
  for (double& value : command.linear) value *= factor;
  for (double& value : command.angular) value *= factor;
  return command;
}

/// No robot is meant to drive so fast, or no number is meant at all.
inline bool is_absurd(const Command& command) {
  constexpr double fastest = 20.0, fastest_turn = 60.0;  // [m/s], [rad/s]
  for (const double value : command.linear)
    if (!(std::abs(value) <= fastest)) return true;
  for (const double value : command.angular)
    if (!(std::abs(value) <= fastest_turn)) return true;
  return false;
}

inline bool stands(const Twist2& twist) { return twist.vx == 0.0 && twist.vy == 0.0 && twist.w == 0.0; }

inline bool same(const Twist2& a, const Twist2& b) { return a.vx == b.vx && a.vy == b.vy && a.w == b.w; }

}  // namespace safety_control_cloud
