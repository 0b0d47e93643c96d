// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "decision.hpp"
#include "sensor.hpp"
#include "settings.hpp"
#include "speed/zone.hpp"
#include "unplaced.hpp"

namespace safety_control_cloud {

/// Decides how fast the robot may go, one cloud at a time, by the worst that its sensors say. Needs no ROS and no
/// clock: the time is an argument.
class SafetyControl {
 public:
  /// Throws std::invalid_argument with all problems_in(settings), if there are any.
  explicit SafetyControl(const Settings& settings);

  /// The decision for a cloud that has just arrived, readable or not.
  Decision decide(const Reading& reading, const Origin& origin, const Instant& now, Crop crop = Crop::Skip);

  /// The decision that holds when no cloud arrives: the last one until source_timeout, then stop.
  Decision without_cloud(const Instant& now);

  /// What is in doubt outside of the sensors, such as who else commands the robot. From the next decision on the robot
  /// stands for it, until there is none.
  void note_outside(std::optional<Doubt> doubt) { outside_ = std::move(doubt); }

  /// Goes on with other settings; throws like the constructor and then keeps the old ones.
  void adopt(const Settings& settings);

  /// Forgets the near obstacles that were lost from sight: somebody has looked.
  void forget_losses();

  /// What each sensor has near or lost, to outlive the process; empty text where nothing is. Then what is unplaced.
  std::vector<std::string> remembered() const;

  /// Goes on with what another process remembered, as a guard of one sensor too. False if not with all of it: for the
  /// rest the robot stands.
  bool recall(const std::vector<std::string>& remembered);

  const Settings& settings() const { return settings_; }

 private:
  /// The worst that the sensors say, of equals the first; before all of them a doubt from outside, and what is
  /// unplaced, unless a sensor is in doubt.
  Decision verdict() const;
  bool is_any_in_doubt() const;
  const Decision& latched(Decision verdict, double now);
  void worsen();

  Settings settings_;
  std::vector<Sensor> sensors_;
  std::optional<Doubt> outside_;
  Unplaced unplaced_;
  ZoneLatch latch_;
  Decision last_;
};

}  // namespace safety_control_cloud
