// SPDX-License-Identifier: BSD-3-Clause
#include "guard.hpp"

#include <algorithm>
#include <cmath>

#include "../path/sweep.hpp"
#include "../text/words.hpp"
#include "caps.hpp"
#include "eye.hpp"
#include "remembered_place.hpp"

namespace safety_control_cloud {
namespace {

constexpr double most_beside = 0.1;  ///< [m] what lies beside a picture counts as nearer than reckoned by no more
constexpr double sharp = 1.0;        ///< [rad/m]

Allowed standing(const std::string& sensor, const Doubt& doubt) {
  return {0.0, 0.0, std::nullopt, sensor, doubt.cause, doubt.reason};
}

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
  if (known.is_missed) return std::min(well_known, widening);
  if (!is_shown) return widening;
  const double tolerated = turns_sharply(wanted) ? 0.0 : well_known;
  return std::clamp(widening - tolerated, 0.0, most_beside);
}

bool may_leave(const Known& known, const Twist2& wanted) {
  if (!known.eye) return false;
  const bool ahead = dot(known.eye->direction, linear(wanted)) > 0.0;
  return leads_away_from(*known.eye, wanted) || (known.is_placed && !ahead);
}

/// Whether who may have come there meanwhile would be seen, if not too near for that.
bool is_watched(const Outline& outline, const Known& known, const Twist2& twist) {
  return std::any_of(known.watched_by.begin(), known.watched_by.end(),
                     [&](const Eye& eye) { return leads_to_where_it_looks(outline, eye, twist); });
}

bool turns_to_what_is_beside(const Twist2& twist) { return speed_of(twist) > 0.0 && turns_sharply(twist); }

/// Whether who may have walked on would be seen, but too late for more than going slowly.
bool creeps(const Outline& outline, const Known& known, const Twist2& twist) {
  return known.is_at_large && turns_to_what_is_beside(twist) && is_watched(outline, known, twist);
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
  Allowed capped = Caps{settings_, outline_}.of(wanted, known);
  if (capped.factor == 0.0) return capped;
  const Twist2 slower = limited(wanted, capped.factor);
  const UnderWay of_slower{under_way.twists, std::min(1.0, under_way.slowing / capped.factor)};
  Allowed seen;
  for (const Known& one : known) seen = lesser(std::move(seen), by_sight(slower, of_slower, one));
  if (seen.factor >= 1.0) return capped;
  seen.in_view = capped.in_view;
  seen.factor *= capped.factor;
  seen.time_to_contact *= capped.factor;
  return seen;
}

Allowed Guard::at_most(const Twist2& wanted, double fastest) const {
  return Caps{settings_, outline_}.at_most(wanted, fastest);
}

Allowed Guard::by_sight(const Twist2& wanted, const UnderWay& under_way, const Known& known) const {
  Allowed least;
  if (!known.rings) return standing(known.sensor, {Cause::NoCloud, "nothing has been seen yet"});
  const bool is_shown = known.is_reckoned && known.seen_by && leads_to_where_it_looks(outline_, *known.seen_by, wanted);
  if (known.is_missed && !is_shown) return least;  // it counts already, with all that is reckoned
  if (known.is_at_large && !turns_to_what_is_beside(wanted) && is_watched(outline_, known, wanted)) return least;
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
/// he turns toward it, or nobody knows well where it is. Then he is let creep, as where nothing is seen: past what may
/// be anywhere, or what he clears where it most likely is. What its picture misses counts for him too, wherever it may
/// be within that.
Allowed Guard::by_ring(const Twist2& wanted, const UnderWay& under_way, const Known& known, const Ring& ring,
                       std::size_t nearer, bool is_shown) const {
  Allowed least;
  if (ring.returns == 0) return least;
  const double creeping = std::min(1.0, settings_.unseen_speed / fastest_point(outline_, wanted));
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
  const auto may_creep = [&](const Obstacles& likely) {
    const bool is_guessed = is_shown && !known.is_missed, is_vague = ring.obstacles.widening > well_known;
    if ((is_guessed && is_vague) || creeps(outline_, known, wanted)) return true;
    if (!is_guessed || off <= 0.0) return false;
    const Outline as_it_is(widened(outline_, widening - off));
    return safety_control_cloud::limit(as_it_is, known.law, likely, known.age, under_way, wanted).factor >= creeping;
  };
  for (const Pose2& way : known.ways) {
    Obstacles moved = seen_after(way, ring.obstacles);
    if (known.is_missed || is_shown) {
      moved.condition = Condition([&](const Point2& point) {
        const bool is_seen = !known.is_missed && known.seen_by->sees(point);
        return !is_seen && is_approached(point, outline_, wanted);
      });
    }
    Limit limit = safety_control_cloud::limit(outline, law, moved, known.age, under_way, wanted);
    if (limit.factor < creeping && may_creep(moved)) limit.factor = creeping;
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
