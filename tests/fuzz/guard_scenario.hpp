// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scenario.hpp"

namespace safety_control_cloud {

/// Which of a few values each of the guard's settings has.
struct GuardChoice {
  Choice look;
  std::uint8_t footprint = 0, deceleration = 0, obstacle_speed = 0, override_max = 0, unseen_speed = 0;
  std::uint8_t zone_caps = 0, memory_distance = 0;
};

enum class GuardEvent : std::uint8_t {
  Look,
  Want,
  Odometry,
  Pose,
  Switch,
  Outside,
  Override,
  Settings,
  Forget,
  Restart,
  Quiet,
};

/// One thing that happens to the guard.
struct GuardStep {
  GuardEvent event = GuardEvent::Quiet;
  std::uint16_t elapsed = 20;     ///< [ms] on the steady clock
  std::int16_t ros_elapsed = 20;  ///< [ms] in ROS time
  std::int16_t stamp_age = 0;     ///< [ms]
  std::uint8_t placing = 0;
  std::array<std::uint8_t, 6> numbers = {};  ///< of a command, a pose, an answer: see number_of()
  std::vector<std::uint8_t> bytes;           ///< a picture's pixels, or a wall's one
  GuardChoice choice;                        ///< of other settings
};

/// Reads a step from a Tape, or writes it to a Recording.
template <class Archive>
void travel(Archive& archive, GuardStep& step) {
  travel_moment(archive, step, 11);
  if (step.event == GuardEvent::Settings) archive(step.choice);
  if (step.event == GuardEvent::Look) archive(step.placing), archive(step.bytes);
  if (step.event != GuardEvent::Look) archive(step.numbers);
}

}  // namespace safety_control_cloud
