// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "../path/outline.hpp"
#include "../speed/law.hpp"
#include "../speed/limit.hpp"
#include "command.hpp"
#include "known.hpp"
#include "settings.hpp"

namespace safety_control_cloud {

/// How much of a motion is safe, and what decided it.
struct Allowed {
  double factor = 1.0;                                               ///< in [0, 1]
  double time_to_contact = std::numeric_limits<double>::infinity();  ///< [s] of the wanted twist
  std::optional<Point2> point;  ///< [m] in base_frame of now, that decided; none: none did
  std::string sensor;           ///< that decided; empty: none did
  Cause cause = Cause::Seen;
  std::string reason;     ///< in words
  std::string hint = {};  ///< what would free the robot, if it stands for what nobody sees any more
  bool in_view = false;   ///< some sensor looks where it leads
};

/// What a robot of this shape may do of what is wanted. Pure: all that changes is an argument.
class Guard {
 public:
  /// The settings are fit.
  explicit Guard(const GuardSettings& settings);

  /// `under_way` as limit() has it; the least of what the sensors allow.
  Allowed allowed(const Twist2& wanted, const UnderWay& under_way, const std::vector<Known>& known) const;

  /// The same where nobody asks what is seen: no faster than `fastest` [m/s] for the fastest point.
  Allowed at_most(const Twist2& wanted, double fastest) const;

  const Outline& outline() const { return outline_; }

  /// [m] beyond which nothing is reached by the fastest motion, given a sensor that is up to `oldest` [s] old.
  double reach(double oldest, const Law& law) const;

 private:
  Allowed by_speed(const Twist2& wanted) const;
  Allowed by_sight(const Twist2& wanted, const UnderWay& under_way, const Known& known) const;
  Allowed by_ring(const Twist2& wanted, const UnderWay& under_way, const Known& known, const Ring& ring,
                  std::size_t nearer, bool is_shown) const;
  Allowed by_zones(const Twist2& wanted, const std::vector<Known>& known) const;
  bool is_in_view(const Twist2& wanted, const std::vector<Known>& known) const;
  Allowed by_eyes(const Twist2& wanted, const std::vector<Known>& known, bool in_view) const;
  Allowed by_horizon(const Twist2& wanted, const std::vector<Known>& known) const;
  Allowed capped(const Twist2& wanted, double fastest, const std::string& reason) const;

  GuardSettings settings_;
  Outline outline_;
};

}  // namespace safety_control_cloud
