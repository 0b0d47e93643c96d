// SPDX-License-Identifier: BSD-3-Clause
#include "out_of_sight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cell_key.hpp"
#include "extents.hpp"

namespace safety_control_cloud {
namespace {

constexpr double cell = 0.015, layer = 0.1;   ///< [m] across and up
constexpr std::size_t most = 30000;           ///< places
constexpr std::size_t most_of_a_look = 8560;  ///< of these: of a scan with more beams, the last are not kept
constexpr double kept_share = 0.75;           ///< of them where there are too many
constexpr std::uint8_t believed = 2;          ///< looks that show a place, or what is behind it
/// [m] Places are told apart by these; what may be off by more than the last is as the one that is off the most.
constexpr std::array<double, 12> displaced = {0.015, 0.02, 0.03, 0.045, 0.07, 0.12, 0.2, 0.3, 0.45, 0.7, 1.0, 1.5};
constexpr double well_known = 0.2;    ///< [m] what may be off by more explains nothing that is lost, nor grows younger
constexpr double absent_for = 1.25;   ///< [s] without a return where there would be one
constexpr double rests_for = 0.3;     ///< [s] between two looks that show the same place
constexpr double grown_old = 0.5;     ///< of its time
constexpr double own_size = 0.01;     ///< [m] by which a return may lie beside the place of its cell
constexpr double well_placed = 0.02;  ///< [m] odometry that drifted by no more has a place where it is
constexpr double most_foretold = 0.05;  ///< [m] what lies farther aside is not looked for

std::uint64_t key_of(const Point2& place, double height) { return key_of_cell(place, cell, height, layer); }

}  // namespace

void OutOfSight::note(std::size_t sensor, const Look& look, const Whereabouts& robot, double now,
                      const Pose2& meanwhile) {
  looks_.take_placed(sensor, robot, now, look.stamp);
  drop_what_is_over(now);
  if (!remembers()) return places_.clear();
  const SeenAt seen_at(look, limits_.vicinity);
  if (!seen_at.can_tell()) return;
  make_room(robot.pose.place);
  const std::vector<NearReturn> all = near_returns(look, limits_.vicinity, robot.pose, meanwhile);
  const Drift by_look{length_of(meanwhile.place) + robot.foretold.place,
                      std::abs(meanwhile.heading) + robot.foretold.heading};
  std::optional<Extents> extents;
  if (!robot.or_else.empty()) extents.emplace(all);  // by odometry every place counts, however high
  for (const NearReturn& seen : all)
    keep(seen, now, by_look.at(seen.range), extents ? extents->around(seen) : Heights{seen.height, seen.height});
  drop_what_has_gone(look, seen_at, robot, now, by_look);
}

void OutOfSight::note_unplaced(std::size_t sensor, double now) {
  looks_.take(sensor, now);
  drop_what_is_over(now);
}

void OutOfSight::drop_what_is_over(double now) {
  looks_.forget_before(now - limits_.time);
  for (auto it = places_.begin(); it != places_.end();)
    it = shown_by(it->second, now) ? std::next(it) : places_.erase(it);
}

/// For all that one look may show: of too many, the farthest are forgotten.
void OutOfSight::make_room(const Point2& robot) {
  if (places_.size() + most_of_a_look <= most) return;
  const auto range = [&](const Place& place) { return length_of(Point2{place.x, place.y} - robot); };
  std::vector<double> ranges;
  for (const auto& [key, place] : places_) ranges.push_back(range(place));
  const auto last = ranges.begin() + static_cast<std::ptrdiff_t>(kept_share * static_cast<double>(ranges.size()));
  std::nth_element(ranges.begin(), last, ranges.end());
  for (auto it = places_.begin(); it != places_.end();)
    it = range(it->second) > *last ? places_.erase(it) : std::next(it);
}

/// The latest look that showed it; none: its time is over.
const LooksTaken::Taken* OutOfSight::shown_by(const Place& place, double now) const {
  const LooksTaken::Taken* look = looks_.find(place.look);
  return look && now - look->at <= limits_.time ? look : nullptr;
}

void OutOfSight::keep(const NearReturn& seen, double now, double off, const Heights& stands) {
  const std::uint64_t key = key_of(seen.place, seen.height);
  const auto found = places_.find(key);
  if (found == places_.end() && places_.size() >= most) return;
  Place kept{seen.place.x, seen.place.y, seen.height, stands, looks_.latest(), now, now, off};
  if (found != places_.end()) {
    kept.first_seen = found->second.first_seen;
    kept.looks = looks_of(found->second);
    found->second = kept;
    return;
  }
  kept.looks = looks_beside(seen.place, seen.height);
  places_.emplace(key, kept);
}

/// A thin thing before a noisy sensor is seen in another cell by each look.
std::uint8_t OutOfSight::looks_beside(const Point2& place, double height) const {
  std::uint8_t looks = 1;
  for (const double ahead : {0.0, 1.0, -1.0, 2.0, -2.0}) {
    for (const double left : {0.0, 1.0, -1.0, 2.0, -2.0}) {
      const auto beside = places_.find(key_of(place + cell * Point2{ahead, left}, height));
      if (beside != places_.end()) looks = std::max(looks, looks_of(beside->second));
      if (looks == believed) return looks;
    }
  }
  return looks;
}

/// Of a place that the present look shows too.
std::uint8_t OutOfSight::looks_of(const Place& before) const {
  const int looks = before.looks + (before.look == looks_.latest() ? 0 : 1);
  return static_cast<std::uint8_t>(std::min<int>(looks, believed));
}

/// `by_look`: by how far the robot may have been elsewhere as the look was taken.
/// Where nobody knows quite where the robot is, or was, only what would be shown wherever that is: `beside` tells how
/// far off in depth, and places to both sides are asked about too. A scan is told by how much it lies `aside`. Of who
/// has no odometry, or had none as that was seen, the ways that it may have gone tell.
void OutOfSight::drop_what_has_gone(const Look& look, const SeenAt& seen_at, const Whereabouts& robot, double now,
                                    const Drift& by_look) {
  const SeenAfter seen_after(robot.pose);
  WaySince way_since(looks_, robot);
  const bool is_scan = std::holds_alternative<ScanView>(look.reading);
  const auto from_camera = [&](const Point2& here, float height) {
    return look.outlook.seen_from_camera(in_corridor_axes(here, height));
  };
  for (auto it = places_.begin(); it != places_.end();) {
    Place& place = it->second;
    if (place.look == looks_.latest()) {
      ++it;
      continue;
    }
    const Point2 here = seen_after({place.x, place.y});
    const double range = length_of(here);
    if (robot.foretold.at(range) > most_foretold) {
      ++it;
      continue;
    }
    const double by_way = way_since.beside(place.look, range), off_by_look = by_look.at(range);
    const double drifted = way_since.off(place.look, range) - by_way;
    const double by_drift = robot.or_else.empty() && drifted > well_placed ? drifted : 0.0;
    const double beside = place.off + by_way + off_by_look + by_drift;
    const double sideways = by_drift + (is_scan ? 0.0 : off_by_look);
    const Point there = from_camera(here, place.z);
    const double aside = by_look.heading + by_look.place / std::max(range, own_size);
    AtPlace seen = seen_at(there, beside, aside);
    const auto ask_also_at = [&](const Point2& at) {
      if (seen != AtPlace::NotThere) seen = std::min(seen, seen_at(from_camera(at, place.z), beside, aside));
    };
    for (const Pose2& way : way_since.or_else(place.look)) ask_also_at(SeenAfter(way)(here));
    if (sideways > 0.0) {
      const Point2 left = (sideways / std::max(range, own_size)) * Point2{-here.y, here.x};
      ask_also_at(here + left);
      ask_also_at(here - left);
    }
    if (seen == AtPlace::ShownFar) {
      place.off += by_way + drifted;  // it is where it was taken to be, or within that
      place.look = looks_.latest();
      place.last_seen = now;
    }
    const bool may_be_kept = place.off + by_way + drifted <= well_known && grows_old(place, now);
    if (may_be_kept && seen == AtPlace::NotThere && seen_at.goes_on_in_picture(there))
      keep_with_what_is_shown(place, by_way + drifted);
    const bool is_measured = there.getVector3fMap().norm() >= static_cast<float>(look.measures_from + beside);
    it = has_gone(place, seen, is_measured, now) ? places_.erase(it) : std::next(it);
  }
}

/// And the latest look is of the sensor that showed it.
bool OutOfSight::grows_old(const Place& place, double now) const {
  const LooksTaken::Taken& look = *looks_.find(place.look);
  return now - look.at > grown_old * limits_.time && look.sensor == looks_.find(looks_.latest())->sensor;
}

/// The front of a pallet, as long as its back is shown. As of the look before, since the latest does not show it.
void OutOfSight::keep_with_what_is_shown(Place& place, double off) {
  const auto before = looks_.placed_before_latest_of(looks_.find(place.look)->sensor);
  if (!before || *before <= place.look) return;
  place.off += off;
  place.look = *before;
}

/// What is shown has its place anew, from this look. What a sensor could measure and does not is kept for a while: some
/// things return from one side only.
bool OutOfSight::has_gone(Place& place, AtPlace seen, bool is_measured, double now) const {
  const bool tells_nothing = seen == AtPlace::NotThere || (seen == AtPlace::Nothing && !is_measured);
  if (tells_nothing || seen == AtPlace::ShownFar) {
    place.absent_since.reset();
    return false;
  }
  if (seen == AtPlace::Shown) return true;
  if (seen == AtPlace::Behind) ++place.away;
  if (!place.absent_since) place.absent_since = now;
  return place.away >= believed || now - *place.absent_since >= absent_for;
}

bool OutOfSight::counts(const Place& place, double now) const {
  return place.looks >= believed && shown_by(place, now);
}

bool OutOfSight::holds_any(double now) const {
  return std::any_of(places_.begin(), places_.end(), [&](const auto& entry) { return counts(entry.second, now); });
}

template <class Visit>
void OutOfSight::for_each(const Whereabouts& robot, double now, Visit visit) const {
  const SeenAfter seen_after(robot.pose);
  WaySince way_since(looks_, robot);
  for (const auto& [key, place] : places_) {
    if (!counts(place, now)) continue;
    const Point2 here = seen_after({place.x, place.y});
    const double range = length_of(here);
    const double off = own_size + place.off + way_since.off(place.look, range) + robot.foretold.at(range);
    visit(place, Here{here, range, off, *looks_.find(place.look)});
  }
}

/// What each may be off by until now stays with it.
void OutOfSight::go_on_in_frame(const Whereabouts& robot, const Whereabouts& there, double now, const RobotAt& was_at) {
  decltype(places_) places;
  for_each(robot, now, [&](const Place& place, const Here& here) {
    const auto then = was_at && here.look.stamp ? was_at(*here.look.stamp) : std::nullopt;
    const Pose2& from = then ? then->pose : there.pose;
    const Point2 seen = then ? SeenAfter(here.look.robot.pose)({place.x, place.y}) : here.place;
    const Point2 at = from.place + Turn(from.heading)(seen);
    Place moved = place;
    moved.x = at.x, moved.y = at.y;
    moved.off = then ? place.off + drift_between(*then, there).at(here.range) + then->foretold.at(here.range)
                     : here.off - own_size;
    places.emplace(key_of(at, place.z), moved);
  });
  places_ = std::move(places);
  looks_.go_on_in_frame(there);
}

std::vector<KeptPlace> OutOfSight::placed(const Whereabouts& robot, double now) const {
  std::vector<KeptPlace> places;
  for_each(robot, now, [&](const Place& place, const Here& here) {
    places.push_back({here.place, place.z, here.off - own_size});
  });
  return places;
}

void OutOfSight::recall(const std::vector<KeptPlace>& places, std::size_t sensor, const Whereabouts& there,
                        double now) {
  looks_.take_placed(sensor, there, now);
  const Turn turn(there.pose.heading);
  for (const KeptPlace& one : places) {
    const Point2 at = there.pose.place + turn(one.place);
    const auto height = static_cast<float>(one.height);
    places_.emplace(key_of(at, height),
                    Place{at.x, at.y, height, {height, height}, looks_.latest(), now, now, one.off, believed});
  }
}

std::vector<KnownPlace> OutOfSight::resting(const Outlook& camera, const Whereabouts& robot, double now) const {
  std::vector<KnownPlace> places;
  for_each(robot, now, [&](const Place& place, const Here& here) {
    if (place.last_seen - place.first_seen < rests_for || here.off > well_known) return;
    const double off = here.off + limits_.speed * (now - place.last_seen);
    places.push_back(
        {here.place, camera.seen_from_camera(in_corridor_axes(here.place, place.z)), off, place.last_seen});
  });
  return places;
}

OutOfSight::Rings OutOfSight::rings(const Whereabouts& robot, double reach, double now, const std::vector<bool>& shows,
                                    std::optional<std::size_t> of, const AsksFor& asks) const {
  const std::vector<Ring> empty(displaced.size(), Ring{reach, {}});
  Rings rings{empty, empty};
  const auto is_shown = [&](const Place& place, const Here& here) {
    return shows[here.look.sensor] && looks_.is_latest_of_its_sensor(place.look);
  };
  for_each(robot, now, [&](const Place& place, const Here& here) {
    if ((of && here.look.sensor != *of) || is_shown(place, here) || here.range - here.off > reach) return;
    const auto fits = std::lower_bound(displaced.begin(), displaced.end() - 1, here.off);
    const auto add_to = [&, i = static_cast<std::size_t>(fits - displaced.begin())](std::vector<Ring>& some) {
      some[i].obstacles.points.push_back(here.place);
      some[i].obstacles.widening = std::max(some[i].obstacles.widening, here.off);
      ++some[i].returns;
    };
    add_to(rings.all);
    if (asks && asks(here.place, place.stands, here.off)) add_to(rings.asked_for);
  });
  return rings;
}

}  // namespace safety_control_cloud
