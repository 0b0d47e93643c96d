// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "../doubt/cause.hpp"
#include "../path/plane.hpp"

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

inline Allowed lesser(Allowed a, Allowed b) { return b.factor < a.factor ? std::move(b) : std::move(a); }

}  // namespace safety_control_cloud
