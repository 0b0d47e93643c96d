// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../path/contact.hpp"
#include "law.hpp"

namespace safety_control_cloud {

/// What a robot may drive of a wish, and why not all of it.
struct Limit {
  double factor = 1.0;     ///< in [0, 1], for limited(wanted, factor)
  Contact contact;         ///< what the factor was decided by, [s] of the wanted twist; times that matter to none are
                           ///< infinite
  bool is_escape = false;  ///< the way leads out of the margin, at escape_speed
};

/// The greatest factor, as far as the law can tell, from which the robot still stops before it touches what was seen.
/// `age` [s]: that of the obstacles, which are given at their places of now. `under_way`: all that the robot may be
/// doing until a new command has its effect: its twist of now, and every command given in the last law.latency +
/// law.base_reaction; none: it stands.
///
/// The wider a robot may stray from its path the less it may drive, and it strays less if it drives less: factors are
/// tried from 1 down in steps, each with the margin that the step needs, until one holds. Several sensors: the least
/// factor of theirs. Nothing is asked of a robot that wants to stand.
///
/// What is inside the margin already is touched at once, unless the motion surely leads away from it (escape.hpp): then
/// the fastest point of the footprint may drive at escape_speed, as far as all else allows it by the law. That needs
/// obstacles that were not reduced: none of them with a widening.
///
/// `law` must be free of problems_in(law). A twist that is not sound stands.
Limit limit(const Outline& outline, const Law& law, const Obstacles& obstacles, double age,
            const std::vector<Twist2>& under_way, const Twist2& wanted);

}  // namespace safety_control_cloud
