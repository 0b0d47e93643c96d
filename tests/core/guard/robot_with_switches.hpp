// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "guarded_robot.hpp"

namespace safety_control_cloud {

/// Which of its switches.
constexpr std::size_t bumper = 0, cliff = 1, kobuki = 2;
constexpr Twist2 forward{0.3, 0.0, 0.0}, backward{-0.3, 0.0, 0.0}, turning{0.0, 0.0, 0.5};

inline Settings with_switches() {
  Settings settings = guard_settings();
  settings.switches = {{"bumper", SwitchKind::Bumper, "bumper", Edge::Front, 0.0},
                       {"cliff", SwitchKind::Cliff, "cliff", Edge::FrontLeft, 0.0},
                       {"kobuki", SwitchKind::Bumper, "events", std::nullopt, 0.0}};
  return settings;
}

/// In a free hall; its camera goes on.
struct RobotWithSwitches : GuardedRobot {
  explicit RobotWithSwitches(const Settings& settings = with_switches()) : GuardedRobot(settings) {
    drives(hall, forward);
  }

  void says(std::size_t which, Edge edge, bool touched, const std::string& who = "driver") {
    control.note_switch(which, who, edge, touched, now);
  }

  /// Found out a moment after the latest word.
  void live(std::size_t which, const std::vector<std::string>& who) {
    now = {now.steady + 0.001, now.ros + 0.001};
    control.note_switch_living(which, who, now.steady);
    now = {now.steady + 0.001, now.ros + 0.001};
  }

  const Guarded& goes_on(double seconds, const Twist2& twist) {
    for (double gone = 0.0; gone < seconds - 1e-9; gone += 0.05) drives_on(hall, twist);
    return wants(twist);
  }

  Scene hall{{}};
};

}  // namespace safety_control_cloud
