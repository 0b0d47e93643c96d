// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "guard/closed_edges.hpp"
#include "guard/given.hpp"
#include "guard/guard.hpp"
#include "guard/odometry.hpp"
#include "guard_memory.hpp"
#include "guard_sensor.hpp"
#include "settings.hpp"
#include "unplaced.hpp"

namespace safety_control_cloud {

/// All that is known around the robot in mode guard: what each sensor sees, what the switches at its edges say, where
/// it went, and what is remembered of that, by this process or the one before.
class Perception {
 public:
  /// The settings are fit; `guard` was made of them.
  Perception(const Settings& settings, const Guard& guard);

  /// Goes on with other settings. With other sensors it begins anew.
  void adopt(const Settings& settings, const Guard& guard);

  /// A reading of one of sensors_of(settings) has come, readable or not, at a robot that was `given` this.
  void see(const Reading& reading, const Origin& origin, const Instant& now, std::size_t sensor, const Given& given);

  Odometry& odometry() { return odometry_; }
  const Odometry& odometry() const { return odometry_; }
  ClosedEdges& switches() { return closed_; }
  GuardSensor& sensor(std::size_t i) { return sensors_[i]; }

  /// Nobody listened for so long [s] until now, as the robot did what it was `given`.
  void note_deafness(double seconds, const Instant& now, const Given& given);

  /// What is in doubt outside of the sensors, until there is none.
  void note_outside(std::optional<Doubt> doubt) { outside_ = std::move(doubt); }
  bool is_in_doubt_outside() const { return outside_.has_value(); }

  /// By each sensor that is to be believed or required, by the memory and by the switches; never nothing. What speaks
  /// against odometry or a sensor that is not required comes to the `doubts`, its name first.
  std::vector<Known> known_at(const Instant& now, const Given& given, const Guard& guard,
                              std::vector<std::string>& doubts);

  void forget_losses();

  /// What each sensor remembers, in their order, what is unplaced, and last what none shows any more. Before what a
  /// sensor remembers stands its name, if it has one: who has none is the camera that drives in the other mode.
  std::vector<std::string> remembered() const;

  /// Goes on with what another process remembered, in either mode. False if not with all of it: for the rest the robot
  /// stands.
  bool recall(const std::vector<std::string>& remembered);

  /// [s] until the next sensor or switch counts as silent; infinite if none will.
  double until_silent(double now) const;

  /// What the latest reading held of the sensor of this name, or else of the first.
  const Sight& sight_of(const std::string& sensor) const;

 private:
  void explain_blindness(std::size_t sensor, const Origin& origin, const Instant& now, const Given& given);
  std::string name_before_losses(const GuardSensor& sensor) const;
  bool go_on_with(const std::string& line);
  std::optional<Known> known_of_unplaced(const Instant& now);

  Settings settings_;
  std::vector<GuardSensor> sensors_;
  ClosedEdges closed_;
  GuardMemory memory_;
  Unplaced unplaced_;
  Odometry odometry_;
  std::optional<Doubt> outside_;
};

}  // namespace safety_control_cloud
