// SPDX-License-Identifier: BSD-3-Clause
#include "guard.hpp"

#include <algorithm>
#include <cmath>

#include "../path/sweep.hpp"
#include "../text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double most_beside = 0.1;    ///< [m] what lies beside a picture counts as nearer than reckoned by no more
constexpr double well_reckoned = 0.2;  ///< [m] what may be off by no more most likely is where it was reckoned to be
constexpr double sharp = 1.0;          ///< [rad/m]

Allowed standing(const std::string& sensor, const Doubt& doubt) {
  return {0.0, 0.0, std::nullopt, sensor, doubt.cause, doubt.reason};
}

Allowed lesser(Allowed a, Allowed b) { return b.factor < a.factor ? std::move(b) : std::move(a); }

Footprint widened(const Outline& outline, double widening) {
  Footprint footprint{{}, outline.radius(), outline.margin() + widening};
  for (const Side& side : outline.sides()) footprint.polygon.push_back(side.segment.from);
  return footprint;
}

std::string in_words(const Limit& limit, const Point2& point) {
  return words(limit.is_escape ? "on the way out of the margin" : "obstacle", " at x ", measured(point.x, "m"), ", y ",
               measured(point.y, "m"));
}

bool turns_sharply(const Twist2& twist) { return std::abs(twist.w) > sharp * speed_of(twist); }

/// [m] By how much nearer than it was reckoned to be something counts that may be off by `widening`.
double counted_nearer(double widening, const Known& known, bool is_shown, const Twist2& wanted) {
  if (known.is_missed) return std::min(well_reckoned, widening);
  if (!is_shown) return widening;
  const double tolerated = turns_sharply(wanted) ? 0.0 : well_reckoned;
  return std::clamp(widening - tolerated, 0.0, most_beside);
}

bool may_leave(const Known& known, const Twist2& wanted) {
  if (!known.eye) return false;
  const bool ahead = dot(known.eye->direction, linear(wanted)) > 0.0;
  return leads_away_from(*known.eye, wanted) || (known.is_placed && !ahead);
}

/// What the whole of a motion would run into, where the part of it that is left clears all.
Contact on_the_path(const Outline& outline, const Obstacles& obstacles, const Twist2& wanted) {
  const Sweep sweep(outline, wanted);
  return contact(obstacles, 1, 0.0, time_by(sweep));
}

}  // namespace

Guard::Guard(const GuardSettings& settings) : settings_(settings), outline_(footprint_of(settings)) {}

/// Straying (speed/straying.hpp) grows with the time in which the base changes its twist; three times that of braking
/// is more than it comes to.
double Guard::reach(double oldest, const Law& law) const {
  const double fastest = settings_.max_speed + settings_.max_turn * outline_.turning_reach();
  const double braking =
      std::max(settings_.max_speed / law.linear_deceleration, settings_.max_turn / law.angular_deceleration);
  const double time = oldest + law.sensor_period + law.latency + law.base_reaction + 3.0 * braking;
  return outline_.reach() + outline_.margin() + (fastest + law.obstacle_speed) * time;
}

Allowed Guard::allowed(const Twist2& wanted, const UnderWay& under_way, const std::vector<Known>& known) const {
  if (known.empty()) return standing({}, {Cause::NoCloud, "there is no sensor"});
  for (const Known& one : known) {
    if (one.doubt) return standing(one.sensor, *one.doubt);
    if (one.lost && !may_leave(one, wanted)) {
      Allowed none = standing(
          one.sensor,
          {one.lost->cause, one.lost->reason + (one.is_placed ? "; not ahead" : "; only straight away from there")});
      none.hint = one.hint;
      return none;
    }
  }
  const bool in_view = is_in_view(wanted, known);
  Allowed capped = lesser(lesser(by_speed(wanted), by_eyes(wanted, known, in_view)), by_zones(wanted, known));
  if (Allowed within = by_horizon(limited(wanted, capped.factor), known); within.factor < 1.0) {
    within.factor *= capped.factor;
    capped = std::move(within);
  }
  capped.in_view = in_view;
  if (capped.factor == 0.0) return capped;
  const Twist2 slower = limited(wanted, capped.factor);
  const UnderWay of_slower{under_way.twists, std::min(1.0, under_way.slowing / capped.factor)};
  Allowed seen;
  for (const Known& one : known) seen = lesser(std::move(seen), by_sight(slower, of_slower, one));
  if (seen.factor >= 1.0) return capped;
  seen.in_view = in_view;
  seen.factor *= capped.factor;
  seen.time_to_contact *= capped.factor;
  return seen;
}

Allowed Guard::at_most(const Twist2& wanted, double fastest) const {
  return lesser(by_speed(wanted), capped(wanted, fastest, "slower than wanted"));
}

Allowed Guard::capped(const Twist2& wanted, double fastest, const std::string& reason) const {
  Allowed allowed;
  const double speed = fastest_point(outline_, wanted);
  if (speed <= fastest) return allowed;
  allowed.factor = fastest / speed;
  allowed.reason = reason;
  return allowed;
}

Allowed Guard::by_speed(const Twist2& wanted) const {
  Allowed allowed;
  const double speed = speed_of(wanted), turning = std::abs(wanted.w);
  if (speed > settings_.max_speed) allowed.factor = settings_.max_speed / speed;
  if (turning > settings_.max_turn) allowed.factor = std::min(allowed.factor, settings_.max_turn / turning);
  if (allowed.factor < 1.0) allowed.reason = "faster than max_speed or max_turn";
  return allowed;
}

/// Of what leads to where a sensor looks; turning is none of it.
Allowed Guard::by_zones(const Twist2& wanted, const std::vector<Known>& known) const {
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
bool Guard::is_in_view(const Twist2& wanted, const std::vector<Known>& known) const {
  return std::any_of(known.begin(), known.end(), [&](const Known& one) {
    return !one.lost && one.eye && !leads_into_the_unseen(outline_, *one.eye, wanted);
  });
}

/// Where nobody looks, no faster than is said for that; nor than out of the margin, away from what was lost.
Allowed Guard::by_eyes(const Twist2& wanted, const std::vector<Known>& known, bool in_view) const {
  const auto slowly_from = [&](const Known& one, Allowed least) {
    if (!one.lost) return least;
    return lesser(std::move(least), capped(wanted, settings_.escape_speed, one.lost->reason));
  };
  Allowed least;
  for (const Known& one : known)
    if (one.is_touched) least = slowly_from(one, std::move(least));
  if (in_view) return least;
  least = lesser(std::move(least), capped(wanted, settings_.unseen_speed, "no sensor looks there: unseen_speed"));
  for (const Known& one : known) least = slowly_from(one, std::move(least));
  return least;
}

/// No faster than it can stop within what is seen there, unless that is slower than where nothing is seen.
Allowed Guard::by_horizon(const Twist2& wanted, const std::vector<Known>& known) const {
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
  const double time = time_to_horizon(outline_, looking, wanted, stopping_time(1.0, slowest.reaction, slowest.braking));
  const double factor = greatest_factor(time, slowest), speed = fastest_point(outline_, wanted);
  if (factor >= 1.0 || speed <= settings_.unseen_speed) return allowed;
  allowed.factor = std::max(factor, settings_.unseen_speed / speed);
  allowed.reason = "no sensor sees so far there that the robot could stop";
  return allowed;
}

Allowed Guard::by_sight(const Twist2& wanted, const UnderWay& under_way, const Known& known) const {
  Allowed least;
  if (!known.rings) return standing(known.sensor, {Cause::NoCloud, "nothing has been seen yet"});
  const bool is_shown = known.is_reckoned && known.seen_by && leads_to_where_it_looks(outline_, *known.seen_by, wanted);
  if (known.is_missed && !is_shown) return least;  // it counts already, with all that is reckoned
  std::size_t nearer = 0;
  for (const Ring& ring : *known.rings) {
    least = lesser(std::move(least), by_ring(wanted, under_way, known, ring, nearer, is_shown));
    if (least.factor == 0.0) break;
    nearer += ring.returns;
  }
  if (!known.lost) least.hint = known.hint;
  return least;
}

/// Returns of the rings inside count as touched already, so that an obstacle that two rings share is one. What is
/// placed by what the base was told counts wherever it may be; for who drives where the sensor looks that saw it, only
/// beside what that shows, and where it is most likely to be, or he would not get past anything: not far from there, if
/// he turns toward it, or nobody knows well where it is, who then is let creep as where nothing is seen. What its
/// picture misses counts for him too, wherever it may be within that.
Allowed Guard::by_ring(const Twist2& wanted, const UnderWay& under_way, const Known& known, const Ring& ring,
                       std::size_t nearer, bool is_shown) const {
  Allowed least;
  if (ring.returns == 0) return least;
  const bool is_vague = is_shown && !known.is_missed && ring.obstacles.widening > well_reckoned;
  const double creeping = is_vague ? std::min(1.0, settings_.unseen_speed / fastest_point(outline_, wanted)) : 0.0;
  const double off = counted_nearer(ring.obstacles.widening, known, is_shown, wanted);
  const double widening = off + half_of_gap(known.ways, std::sqrt(2.0) * ring.extent);
  if (!(outline_.margin() + widening <= most_margin))
    return standing(known.sensor, {Cause::Seen, "something was near, and may be anywhere by now"});
  Law law = known.law;
  law.min_points = law.min_points > nearer ? law.min_points - nearer : 1;
  // What is inside the margin can be left only by who knows the points as they are (limit.hpp), and a robot that was
  // slow to stop may have come near to what was far when it was seen. So the margin is widened, not the points, and the
  // rest is taken off the noise.
  law.noise = std::max(0.5 * law.noise, law.noise - 2.0 * off);
  const Outline outline(widened(outline_, widening));
  for (const Pose2& way : known.ways) {
    Obstacles moved = seen_after(way, ring.obstacles);
    if (known.is_missed || is_shown) {
      moved.condition = Condition([&](const Point2& point) {
        const bool is_seen = !known.is_missed && known.seen_by->sees(point);
        return !is_seen && is_approached(point, outline_, wanted);
      });
    }
    Limit limit = safety_control_cloud::limit(outline, law, moved, known.age, under_way, wanted);
    limit.factor = std::max(limit.factor, creeping);
    if (!(limit.factor < least.factor)) continue;
    const Contact decider = limit.contact.point ? limit.contact : on_the_path(outline, moved, wanted);
    least = {limit.factor, decider.time, std::nullopt, known.sensor, Cause::Seen, "something lies beside the path"};
    if (!decider.point) continue;
    least.point = moved.points[*decider.point];
    least.reason = in_words(limit, *least.point);
  }
  return least;
}

}  // namespace safety_control_cloud
