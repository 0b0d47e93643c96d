// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "doubt/cause.hpp"
#include "look/sight.hpp"
#include "speed/zone.hpp"

namespace safety_control_cloud {

/// How fast the robot may go, and why. As it is made, it says stop.
struct Decision {
  Zone zone = Zone::Danger;
  double speed = 0.0;  ///< [m/s] forward
  Cause cause = Cause::NoCloud;
  std::string reason;               ///< the cause in words, with its figures
  std::optional<Obstacle> nearest;  ///< what the zone was decided by; x and y are NaN if only its distance is known
  std::optional<double> stuck_since;  ///< [s] steady, while it stands for what nobody sees any more
  std::string hint;                   ///< what would free it then
  Sight sight;                      ///< all zero if the cloud could not be looked at
};

}  // namespace safety_control_cloud
