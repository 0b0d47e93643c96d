// SPDX-License-Identifier: BSD-3-Clause
// What a tape's bytes say of a guard's settings and of numbers.
#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <limits>

#include "../../safety_control_cloud/core/guard_control.hpp"
#include "guard_scenario.hpp"
#include "inputs.hpp"

namespace safety_control_cloud {

inline Settings settings_of(const GuardChoice& choice) {
  Settings settings = settings_of(choice.look, Method::OnePass);
  settings.target_frame.clear();
  settings.mode = Mode::Guard;
  settings.footprint.text = one_of<const char*>(
      {"", "[[0.3, 0.2], [-0.3, 0.2], [-0.3, -0.2], [0.3, -0.2]]", "[[0.1, 0.1], [-1.5, 0.0], [0.1, -0.1]]"},
      choice.footprint);
  settings.stopping.base_deceleration = one_of<double>({0.5, 1.0, 0.1}, choice.deceleration);
  settings.obstacle_speed = one_of<double>({0.0, 0.5}, choice.obstacle_speed);
  settings.override_max = one_of<double>({0.0, 5.0}, choice.override_max);
  settings.unseen_speed = one_of<double>({0.1, 0.0}, choice.unseen_speed);
  settings.zone_caps = choice.zone_caps % 2 == 1;
  settings.memory_distance = one_of<double>({1.5, 0.0}, choice.memory_distance);
  settings.switches = {{"front", SwitchKind::Bumper, "bumper", Edge::Front, 0.0}};
  return settings;
}

/// Some that a driver gives, and some that none should.
inline double number_of(std::uint8_t choice) {
  constexpr double special[] = {0.0,    -0.0, std::numeric_limits<double>::quiet_NaN(), -1e-9, 1e300,
                                1e-300, 0.05, std::numeric_limits<double>::infinity()};
  return choice < std::size(special) ? special[choice] : (static_cast<double>(choice) - 128.0) / 100.0;
}

inline Command command_of(const std::array<std::uint8_t, 6>& bytes) {
  Command command;
  for (std::size_t i = 0; i < 3; ++i)
    command.linear[i] = number_of(bytes[i]), command.angular[i] = number_of(bytes[i + 3]);
  return command;
}

}  // namespace safety_control_cloud
