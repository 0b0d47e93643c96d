// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "corridor.hpp"
#include "layout.hpp"
#include "settings.hpp"
#include "speed.hpp"
#include "zone.hpp"

namespace safety_control_cloud {

/// Why a decision is what it is. With every cause but SEEN the node could not look, and the robot stands.
enum class Cause : std::uint8_t {
  Seen = 0,        ///< the cloud could be read and the sensor sees
  NoCloud = 1,     ///< nothing received yet
  Silent = 2,      ///< no cloud for source_timeout
  Unreadable = 3,  ///< the cloud's layout contradicts itself
  Blind = 4,       ///< too few returns to tell free space from no sight
};

const char* name_of(Cause cause);  ///< "SEEN", "NO_CLOUD", ...

/// How fast the robot may go, and why. As it is made, it says stop.
struct Decision {
  Zone zone = Zone::Danger;
  double speed = 0.0;  ///< [m/s] forward
  Cause cause = Cause::NoCloud;
  std::string reason;               ///< the cause in words, with its figures
  std::optional<Obstacle> nearest;  ///< what the zone was decided by
  Sight sight;                      ///< all zero if the cloud could not be looked at
};

/// Decides how fast the robot may go, one cloud at a time. Needs no ROS and no clock: `now` [s] is any clock that never
/// goes back, the same one in every call.
class SafetyControl {
 public:
  /// Throws std::invalid_argument with all problems_in(settings), if there are any.
  explicit SafetyControl(const Settings& settings);

  /// The decision for a cloud that has just arrived, readable or not.
  Decision decide(const Reading& cloud, double now, Crop crop = Crop::Skip);

  /// The decision that holds when no cloud arrives: the last one until source_timeout, then stop.
  Decision without_cloud(double now);

  const Settings& settings() const { return settings_; }

 private:
  Decision decide_by(const Sight& sight, double now);
  Decision stop(Cause cause, std::string reason, double now);

  Settings settings_;
  ZoneLatch latch_;
  std::optional<double> last_arrival_;
  Decision last_;
};

}  // namespace safety_control_cloud
