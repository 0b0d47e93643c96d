// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../path/contact.hpp"
#include "law.hpp"

namespace safety_control_cloud {

/// What a robot may be doing until a new command has its effect: its twist of now, and every command given in the last
/// law.latency + law.base_reaction; none: it stands.
struct UnderWay {
  std::vector<Twist2> twists;
  /// The factor of the wish that a base which brakes no faster than the law's rates is down to before it is told anew,
  /// if it is told to stop; 0: it is not on the path of the wish, or stands by then.
  double slowing = 0.0;
};

/// What a robot may drive of a wish, and why not all of it.
struct Limit {
  double factor = 1.0;     ///< in [0, 1], for limited(wanted, factor)
  Contact contact;         ///< what the factor was decided by, [s] of the wanted twist; times that matter to none are
                           ///< infinite
  bool is_escape = false;  ///< the way leads out of the margin, at escape_speed
};

/// The greatest factor, as far as the law can tell, from which the robot still stops before it touches what was seen.
/// `age`: that of the obstacles, which are given at their places of now.
///
/// The wider a robot may stray from its path the less it may drive, and it strays less if it drives less: factors are
/// tried from 1 down in steps, each with the margin that the step needs, until one holds. Several sensors: the least
/// factor of theirs. Nothing is asked of a robot that wants to stand.
///
/// More than what is under way is given only up to what still holds if the next look shows the obstacle nearer by twice
/// the noise, or by half of the margin, or of the time to contact, whichever is least: or the robot would have to be
/// braked then, and jerk. What it drives already it keeps as long as the law allows.
///
/// Where less than what is under way is left, a command to stop would have the base brake each axis as fast as it can,
/// and leave the path on which it is judged. If it can be slowed along that in time, it is told `slowing` in place of
/// less: the slowest base brakes just so, and none is faster that follows what it is told within the delay. Who lets go
/// of it meanwhile leaves the arc by no more than straying.hpp says.
///
/// What is inside the margin already is touched at once, unless the motion surely leads away from it (escape.hpp): then
/// the fastest point of the footprint may drive at escape_speed, as far as all else allows it by the law. That needs
/// obstacles that were not reduced: none of them with a widening.
///
/// `law` must be free of problems_in(law). A twist that is not sound stands.
Limit limit(const Outline& outline, const Law& law, const Obstacles& obstacles, const Age& age,
            const UnderWay& under_way, const Twist2& wanted);

}  // namespace safety_control_cloud
