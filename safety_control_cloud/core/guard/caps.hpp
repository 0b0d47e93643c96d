// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../path/outline.hpp"
#include "../path/twist.hpp"
#include "allowed.hpp"
#include "known.hpp"
#include "settings.hpp"

namespace safety_control_cloud {

/// How fast a robot of this shape may drive, whatever is in its way. Borrowed for the length of a call.
struct Caps {
  const GuardSettings& settings;
  const Outline& outline;

  /// By its greatest speeds, by the zones, and by where nobody looks, or not far enough to stop in.
  Allowed of(const Twist2& wanted, const std::vector<Known>& known) const;

  /// By its greatest speeds, and no faster than `fastest` [m/s] for the fastest point.
  Allowed at_most(const Twist2& wanted, double fastest) const;

 private:
  Allowed by_point(const Twist2& wanted, double fastest, const std::string& reason) const;
  Allowed by_speed(const Twist2& wanted) const;
  static Allowed by_zones(const Twist2& wanted, const std::vector<Known>& known);
  bool is_in_view(const Twist2& wanted, const std::vector<Known>& known) const;
  Allowed by_eyes(const Twist2& wanted, const std::vector<Known>& known, bool in_view) const;
  Allowed by_horizon(const Twist2& wanted, const std::vector<Known>& known) const;
};

}  // namespace safety_control_cloud
