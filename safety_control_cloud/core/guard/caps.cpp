// SPDX-License-Identifier: BSD-3-Clause
#include "caps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../speed/law.hpp"
#include "../text/words.hpp"
#include "eye.hpp"
#include "horizon.hpp"

namespace safety_control_cloud {

Allowed Caps::of(const Twist2& wanted, const std::vector<Known>& known) const {
  const bool in_view = is_in_view(wanted, known);
  Allowed capped = lesser(lesser(by_speed(wanted), by_eyes(wanted, known, in_view)), by_zones(wanted, known));
  if (Allowed within = by_horizon(limited(wanted, capped.factor), known); within.factor < 1.0) {
    within.factor *= capped.factor;
    capped = std::move(within);
  }
  capped.in_view = in_view;
  return capped;
}

Allowed Caps::at_most(const Twist2& wanted, double fastest) const {
  return lesser(by_speed(wanted), by_point(wanted, fastest, "slower than wanted"));
}

Allowed Caps::by_point(const Twist2& wanted, double fastest, const std::string& reason) const {
  Allowed allowed;
  const double speed = fastest_point(outline, wanted);
  if (speed <= fastest) return allowed;
  allowed.factor = fastest / speed;
  allowed.reason = reason;
  return allowed;
}

Allowed Caps::by_speed(const Twist2& wanted) const {
  Allowed allowed;
  const double speed = speed_of(wanted), turning = std::abs(wanted.w);
  if (speed > settings.max_speed) allowed.factor = settings.max_speed / speed;
  if (turning > settings.max_turn) allowed.factor = std::min(allowed.factor, settings.max_turn / turning);
  if (allowed.factor < 1.0) allowed.reason = "faster than max_speed or max_turn";
  return allowed;
}

/// Of what leads to where a sensor looks; turning is none of it.
Allowed Caps::by_zones(const Twist2& wanted, const std::vector<Known>& known) {
  Allowed least;
  const double speed = speed_of(wanted);
  for (const Known& one : known) {
    if (!one.cap || !(dot(one.cap->ahead, linear(wanted)) > 0.0) || speed <= one.cap->speed) continue;
    Allowed slower;
    slower.factor = one.cap->speed / speed;
    slower.sensor = one.sensor;
    slower.reason = words("zone ", name_of(one.cap->zone), ": ", measured(one.cap->speed, "m/s"));
    least = lesser(std::move(least), std::move(slower));
  }
  return least;
}

/// Whether some sensor looks where this leads.
bool Caps::is_in_view(const Twist2& wanted, const std::vector<Known>& known) const {
  return std::any_of(known.begin(), known.end(), [&](const Known& one) {
    return !one.lost && one.eye && !leads_into_the_unseen(outline, *one.eye, wanted);
  });
}

/// Where nobody looks, no faster than is said for that; nor than out of the margin, away from what was lost.
Allowed Caps::by_eyes(const Twist2& wanted, const std::vector<Known>& known, bool in_view) const {
  const auto slowly_from = [&](const Known& one, Allowed least) {
    if (!one.lost) return least;
    return lesser(std::move(least), by_point(wanted, settings.escape_speed, one.lost->reason));
  };
  Allowed least;
  for (const Known& one : known)
    if (one.is_touched) least = slowly_from(one, std::move(least));
  if (in_view) return least;
  least = lesser(std::move(least), by_point(wanted, settings.unseen_speed, "no sensor looks there: unseen_speed"));
  for (const Known& one : known) least = slowly_from(one, std::move(least));
  return least;
}

/// No faster than it can stop within what is seen there, unless that is slower than where nothing is seen.
Allowed Caps::by_horizon(const Twist2& wanted, const std::vector<Known>& known) const {
  std::vector<Sighted> looking;
  Response slowest{};
  for (const Known& one : known) {
    if (one.lost || !one.eye) continue;
    const Response response = response_to(one.law, one.age, wanted);
    if (response.reaction >= slowest.reaction) slowest = response;
    double gone = 0.0;
    for (const Pose2& way : one.ways) gone = std::max(gone, length_of(way.place));
    const double comes = approach(one.law, one.age, response, 1.0, 0.0);
    looking.push_back({*one.eye, one.horizon, gone + comes});
  }
  Allowed allowed;
  const double time = time_to_horizon(outline, looking, wanted, stopping_time(1.0, slowest.reaction, slowest.braking));
  const double factor = greatest_factor(time, slowest), speed = fastest_point(outline, wanted);
  if (factor >= 1.0 || speed <= settings.unseen_speed) return allowed;
  allowed.factor = std::max(factor, settings.unseen_speed / speed);
  allowed.reason = "no sensor sees so far there that the robot could stop";
  return allowed;
}

}  // namespace safety_control_cloud
