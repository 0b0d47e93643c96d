// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "doubt/cause.hpp"
#include "look/corridor.hpp"
#include "doubt/frozen.hpp"
#include "input/layout.hpp"
#include "memory/near_loss.hpp"
#include "look/placement.hpp"
#include "settings.hpp"
#include "doubt/sources.hpp"
#include "speed/speed.hpp"
#include "speed/zone.hpp"

namespace safety_control_cloud {

/// How fast the robot may go, and why. As it is made, it says stop.
struct Decision {
  Zone zone = Zone::Danger;
  double speed = 0.0;  ///< [m/s] forward
  Cause cause = Cause::NoCloud;
  std::string reason;               ///< the cause in words, with its figures
  std::optional<Obstacle> nearest;  ///< what the zone was decided by; x and y are NaN if only its distance is known
  Sight sight;                      ///< all zero if the cloud could not be looked at
};

/// One moment on two clocks [s].
struct Instant {
  double steady = 0.0;  ///< never goes back
  double ros = 0.0;     ///< ROS time, the clock of the stamps
};

/// Where and when a cloud was taken.
struct Origin {
  double stamp = 0.0;  ///< [s] ROS time
  Placing placing = OpticalFrame{};
  std::string source = {};  ///< who sent it
};

/// Decides how fast the robot may go, one cloud at a time. Needs no ROS and no clock: the time is an argument.
class SafetyControl {
 public:
  /// Throws std::invalid_argument with all problems_in(settings), if there are any.
  explicit SafetyControl(const Settings& settings);

  /// The decision for a cloud that has just arrived, readable or not.
  Decision decide(const Reading& reading, const Origin& origin, const Instant& now, Crop crop = Crop::Skip);

  /// The decision that holds when no cloud arrives: the last one until source_timeout, then stop.
  Decision without_cloud(const Instant& now);

  /// Goes on with other settings; throws like the constructor and then keeps the old ones.
  void take(const Settings& settings);

  /// Forgets the near obstacles that were lost from sight: somebody has looked.
  void forget_losses() { near_loss_.forget(); }

  const Settings& settings() const { return settings_; }

 private:
  std::optional<Decision> doubt_before_looking(const Reading& reading, const Origin& origin, const Instant& now);
  std::optional<Decision> doubt_about(const Sight& sight, const View& view, double stamp, double now);
  Decision decide_by(const Sight& sight, const std::optional<Loss>& loss, double now);
  Decision stop(Cause cause, std::string reason, double now);
  bool clock_went_back(double ros_now);

  Settings settings_;
  Corridor corridor_;
  ZoneLatch latch_;
  NearLoss near_loss_;
  FrozenWatch frozen_;
  std::optional<double> last_arrival_;  ///< [s] steady
  std::optional<double> last_ros_;      ///< [s] ROS time
  SourceWatch sources_;
  Decision last_;
};

}  // namespace safety_control_cloud
