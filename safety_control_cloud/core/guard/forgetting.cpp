// SPDX-License-Identifier: BSD-3-Clause
#include "forgetting.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

constexpr double absent_for = 1.25;     ///< [s] without a return where there would be one
constexpr double shows_for = 1.0;       ///< [s] what a look showed, or two periods of its sensor
constexpr double grown_old = 0.5;       ///< of its time
constexpr double least_range = 0.01;    ///< [m]
constexpr double thinnest = 0.015;      ///< [m] what is no wider may stand between two places that are asked about
constexpr int most_steps = 16;          ///< to each side
constexpr double most_foretold = 0.05;  ///< [m] what lies farther aside is not looked for

/// As this look has it: where it was taken to be, or within `off` [m] of that.
void renew(RememberedPlace& place, std::uint64_t look, double off) {
  place.off += off;
  place.drifted = 0.0;
  place.look = look;
}

}  // namespace

Forgetting::Forgetting(const Look& look, const SeenAt& seen_at, const LooksTaken& looks, const Whereabouts& robot,
                       const Drift& by_look, double now, double time)
    : look_(look),
      seen_at_(seen_at),
      looks_(looks),
      sensor_(looks.find(looks.latest())->sensor),
      is_scan_(std::holds_alternative<ScanView>(look.reading)),
      robot_(robot),
      by_look_(by_look),
      now_(now),
      time_(time),
      seen_after_(robot.pose),
      way_since_(looks, robot) {}

bool Forgetting::has_gone(RememberedPlace& place) {
  if (place.look == looks_.latest() || looks_.is_latest_older_than(place.look)) return false;
  const Point2 here = seen_after_({place.x, place.y});
  const double range = length_of(here);
  if (robot_.foretold.at(range) > most_foretold) return false;
  const double by_way = way_since_.beside(place.look, range), since = by_way + place.drifted;
  const double off = place.off + by_way + by_look_.at(range) + unknown_drift(place);
  const Asked asked{here, from_camera(here, place.z), range, off};
  const AtPlace seen = is_asked_of(place) ? seen_of(place, asked) : AtPlace::NotThere;
  const bool is_known = place.off + since <= well_known;
  if (is_known && seen == AtPlace::ShownOnly) {
    renew(place, looks_.latest(), since);
    place.last_seen = now_;
    place.looks = believed;  // that which kept it, and this one
  }
  if (is_known && seen == AtPlace::NotThere && grows_old(place) && seen_at_.goes_on_in_picture(asked.there))
    keep_with_what_is_shown(place, since);
  const bool is_measured = measured_from(asked.there) >= look_.measures_from + off;
  if (showed_it(place)) place.is_too_near = seen == AtPlace::Nothing && !is_measured;
  return is_proven(place, seen, is_measured);
}

/// The sensor that looks did, and no other since.
bool Forgetting::showed_it(const RememberedPlace& place) const { return looks_.find(place.look)->sensor == sensor_; }

/// Just now, and has not looked past it since: that it measures nothing there says nothing.
bool Forgetting::is_shown_by_another(const RememberedPlace& place) const {
  if (showed_it(place) || place.away > 0) return false;
  const LooksTaken::Taken& shown = *looks_.find(place.look);
  const double age = now_ - shown.at;
  return age <= shows_for || age <= 2.0 * looks_.period_of(shown.sensor);
}

/// A scan is, of what it showed: what a camera saw a few millimetres beside its plane it looks past. Who looked past it
/// before, and another showed it again, is not: glass, or what is black, or whoever is not quite where TF has him. Who
/// did of what another process kept, nobody knows.
bool Forgetting::is_asked_of(const RememberedPlace& place) const {
  return showed_it(place) || (!is_scan_ && !place.is_recalled && !place.do_not_see.has(sensor_));
}

/// [m] A camera is blind by depth: at the side of a wide picture, what lies as near is farther away than that.
double Forgetting::measured_from(const Point& there) const {
  return is_scan_ ? there.getVector3fMap().norm() : there.z;
}

Point Forgetting::from_camera(const Point2& here, float height) const {
  return look_.outlook.seen_from_camera(in_corridor_axes(here, height));
}

/// [m] Of who has no odometry, or had none as that was seen, the ways that it may have gone tell.
double Forgetting::unknown_drift(const RememberedPlace& place) const {
  return robot_.or_else.empty() && place.drifted > well_placed ? place.drifted : 0.0;
}

/// Where nobody knows quite where the robot is, or was, only what would be shown wherever that is: places to both sides
/// are asked about too, one beside the other, and nearer and farther ones, of which the picture may end before the one,
/// or show the end of the thing at the place of its front. A scan is told by how much it lies aside.
AtPlace Forgetting::seen_of(const RememberedPlace& place, const Asked& asked) {
  const Point2& here = asked.here;
  const double distance = std::max(asked.range, least_range);
  const double aside = by_look_.heading + by_look_.place / distance;
  AtPlace seen = seen_at_(asked.there, asked.off, aside);
  const auto ask_also_at = [&](const Point2& at) {
    if (seen != AtPlace::NotThere) seen = std::min(seen, seen_at_(from_camera(at, place.z), asked.off, aside));
  };
  for (const Pose2& way : way_since_.or_else(place.look)) ask_also_at(SeenAfter(way)(here));
  const double drift = unknown_drift(place);
  if (drift > 0.0) {
    const Point2 away = (drift / distance) * here;
    ask_also_at(here - away);
    ask_also_at(here + away);
  }
  const double sideways = drift + (is_scan_ ? 0.0 : by_look_.at(asked.range));
  const int steps = std::clamp(static_cast<int>(std::ceil(sideways / thinnest)), 0, most_steps);
  for (int i = 1; i <= steps; ++i) {
    const Point2 left = (sideways * i / steps / distance) * Point2{-here.y, here.x};
    ask_also_at(here + left);
    ask_also_at(here - left);
  }
  return seen;
}

bool Forgetting::grows_old(const RememberedPlace& place) const {
  return now_ - looks_.find(place.look)->at > grown_old * time_ && showed_it(place);
}

/// The front of a pallet, as long as its back is shown. As of the look before, since the latest does not show it.
void Forgetting::keep_with_what_is_shown(RememberedPlace& place, double off) const {
  const auto before = looks_.placed_before_latest_of(sensor_);
  if (before && *before > place.look) renew(place, *before, off);
}

/// What is shown has its place anew, from this look. What a sensor could measure and does not is kept for a while: some
/// things return from one side only. Another one that does not look there speaks neither for that nor against it.
bool Forgetting::is_proven(RememberedPlace& place, AtPlace seen, bool is_measured) const {
  const bool tells_nothing = seen == AtPlace::NotThere || (seen == AtPlace::Nothing && !is_measured);
  if (tells_nothing || seen == AtPlace::ShownOnly) {
    if (seen == AtPlace::ShownOnly || (place.absent && place.absent->sensor == sensor_)) place.absent.reset();
    return false;
  }
  if (seen == AtPlace::Shown) return true;
  if (is_shown_by_another(place)) {  // its next look tells which of both is right
    place.looked_past.add(sensor_);
    return false;
  }
  if (seen == AtPlace::Behind) ++place.away;
  if (!place.absent) place.absent = RememberedPlace::Absent{now_, sensor_};
  const bool is_long = place.absent->sensor == sensor_ && now_ - place.absent->since >= absent_for;
  return place.away >= believed || is_long;
}

}  // namespace safety_control_cloud
