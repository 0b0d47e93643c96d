// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../path/outline.hpp"
#include "../speed/law.hpp"
#include "../speed/limit.hpp"
#include "allowed.hpp"
#include "known.hpp"
#include "settings.hpp"

namespace safety_control_cloud {

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
  Allowed by_sight(const Twist2& wanted, const UnderWay& under_way, const Known& known) const;
  Allowed by_ring(const Twist2& wanted, const UnderWay& under_way, const Known& known, const Ring& ring,
                  std::size_t nearer, bool is_shown) const;

  GuardSettings settings_;
  Outline outline_;
};

}  // namespace safety_control_cloud
