// SPDX-License-Identifier: BSD-3-Clause
#include "out_of_sight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "cell_key.hpp"
#include "extents.hpp"
#include "forgetting.hpp"
#include "seen_at.hpp"

namespace safety_control_cloud {
namespace {

constexpr double cell = 0.015, layer = 0.1;   ///< [m] across and up
constexpr std::size_t most = 30000;           ///< places
constexpr std::size_t most_of_a_look = 9630;  ///< of these: of a scan with more beams, the last are not kept
constexpr double kept_share = 0.75;           ///< of them where there are too many
/// [m] Places are told apart by these; what may be off by more than the last is as the one that is off the most.
constexpr std::array<double, 12> displaced = {0.015, 0.02, 0.03, 0.045, 0.07, 0.12, 0.2, 0.3, 0.45, 0.7, 1.0, 1.5};
constexpr double rests_for = 0.3;  ///< [s] between two looks that show the same place
constexpr double stays_for = 1.0;  ///< [s] likewise: whoever stands so long is not about to walk
constexpr double one_step = 0.1;   ///< [m] more than anything goes from one look to the next, or is wide
constexpr double own_size = 0.01;  ///< [m] by which a return may lie beside the place of its cell

/// Of the key of a place that is shown once more, where what was there may be elsewhere: it goes as any other.
constexpr std::uint64_t elsewhere = std::uint64_t{1} << 63U;

std::uint64_t key_of(const Point2& place, double height) { return key_of_cell(place, cell, height, layer); }

/// Beside what has the same cell.
void add_to(std::unordered_map<std::uint64_t, RememberedPlace>& places, const RememberedPlace& place) {
  const std::uint64_t key = key_of({place.x, place.y}, place.z);
  if (places.emplace(key, place).second) return;
  const auto [beside, is_new] = places.emplace(key | elsewhere, place);
  if (!is_new) beside->second.off = std::max(beside->second.off, place.off);
}

/// Whether nobody gets out of what an eye sees from there in one step.
bool sees_around(const Eye& eye, const Point2& place) {
  const Point2 there = place - eye.place;
  const Point2 beside = (one_step / std::max(length_of(there), one_step)) * Point2{-there.y, there.x};
  return eye.sees(place - beside) && eye.sees(place) && eye.sees(place + beside);
}

/// By how much it may have been displaced.
void add_to(std::vector<Ring>& rings, const Point2& place, double off) {
  const auto fits = std::lower_bound(displaced.begin(), displaced.end() - 1, off);
  Ring& ring = rings[static_cast<std::size_t>(fits - displaced.begin())];
  ring.obstacles.points.push_back(place);
  ring.obstacles.widening = std::max(ring.obstacles.widening, off);
  ++ring.returns;
}

}  // namespace

void OutOfSight::limit(OutOfSightLimits limits) {
  limits_ = std::move(limits);
  const auto counts = [this](double height) {
    return height >= limits_.vicinity.bottom && height <= limits_.vicinity.top;
  };
  for (auto it = places_.begin(); it != places_.end();) it = counts(it->second.z) ? std::next(it) : places_.erase(it);
}

void OutOfSight::note(std::size_t sensor, const Look& look, const Whereabouts& robot, double now, double came_after,
                      const Pose2& meanwhile) {
  drift(looks_.take_placed(sensor, robot, now, look.stamp, came_after), robot.pose.place);
  drop_what_is_over(now);
  if (!remembers()) return places_.clear();
  const SeenAt seen_at(look, limits_.vicinity);
  if (!seen_at.can_tell()) return;
  make_room(robot.pose.place);
  const std::vector<NearReturn> all = near_returns(look, limits_.vicinity, robot.pose, meanwhile);
  const Drift by_look = Drift{length_of(meanwhile.place), std::abs(meanwhile.heading)} + robot.foretold +
                        looks_.drift_from_latest_to(robot);
  std::optional<Extents> extents;
  if (!robot.or_else.empty()) extents.emplace(all);  // by odometry every place counts, however high
  for (const NearReturn& seen : all)
    keep(seen, now, by_look.at(seen.range), extents ? extents->around(seen) : Heights{seen.height, seen.height});
  Forgetting forgetting(look, seen_at, looks_, robot, by_look, now, limits_.time);
  for (auto it = places_.begin(); it != places_.end();)
    it = forgetting.has_gone(it->second) ? places_.erase(it) : std::next(it);
}

/// A turn moves a place by as much as it was away just then.
void OutOfSight::drift(const Drift& way, const Point2& robot) {
  if (way.place == 0.0 && way.heading == 0.0) return;
  for (auto& [key, place] : places_) place.drifted += way.at(length_of(Point2{place.x, place.y} - robot));
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
  const bool is_kept = found != places_.end();
  if (is_kept && looks_.is_latest_older_than(found->second.look)) {
    found->second.looks = looks_of(found->second);
    return;
  }
  if (!is_kept && places_.size() >= most) return;
  Place kept{seen.place.x, seen.place.y, seen.height, stands, looks_.latest(), now, now, off};
  if (is_kept) {
    // what is back where a look saw past it has been elsewhere
    if (found->second.away == 0) kept.first_seen = found->second.first_seen;
    kept.looks = looks_of(found->second);
    note_who_does_not_see(kept, found->second);
    const Place before = std::exchange(found->second, kept);
    if (before.drifted > well_placed && places_.size() < most) places_.insert_or_assign(key | elsewhere, before);
    return;
  }
  take_over_from_beside(kept);
  places_.emplace(key, kept);
}

/// Who looked past it, or past what is right beside it, is wrong, if it is shown again; but for the one that shows it.
void OutOfSight::note_who_does_not_see(Place& shown, const Place& before) const {
  shown.do_not_see = shown.do_not_see | before.do_not_see | before.looked_past;
  shown.do_not_see.remove(looks_.find(shown.look)->sensor);
}

/// Whether it is so of any place within two cells, from the nearest on.
template <class Is>
bool OutOfSight::any_beside(const Place& place, Is is) const {
  for (const double ahead : {0.0, 1.0, -1.0, 2.0, -2.0}) {
    for (const double left : {0.0, 1.0, -1.0, 2.0, -2.0}) {
      const auto beside = places_.find(key_of(Point2{place.x, place.y} + cell * Point2{ahead, left}, place.z));
      if (beside != places_.end() && is(beside->second)) return true;
    }
  }
  return false;
}

/// A thin thing before a noisy sensor is seen in another cell by each look.
void OutOfSight::take_over_from_beside(Place& shown) const {
  any_beside(shown, [&](const Place& beside) {
    shown.looks = std::max(shown.looks, looks_of(beside));
    if (shown.looks == believed && looks_.sensors() == 1) return true;
    note_who_does_not_see(shown, beside);
    return false;
  });
}

/// Of a place that the present look shows too.
std::uint8_t OutOfSight::looks_of(const Place& before) const {
  const int looks = before.looks + (before.look == looks_.latest() ? 0 : 1);
  return static_cast<std::uint8_t>(std::min<int>(looks, believed));
}

bool OutOfSight::counts(const Place& place, double now) const {
  return place.looks >= believed && shown_by(place, now);
}

bool OutOfSight::holds_any(double now) const {
  return std::any_of(places_.begin(), places_.end(), [&](const auto& entry) { return counts(entry.second, now); });
}

bool OutOfSight::has_seen_any(double now) const {
  return std::any_of(places_.begin(), places_.end(),
                     [&](const auto& entry) { return shown_by(entry.second, now) != nullptr; });
}

/// It, or a part of the same thing before a noisy sensor.
bool OutOfSight::was_staying(const Place& place) const {
  return any_beside(place, [](const Place& beside) { return beside.last_seen - beside.first_seen >= stays_for; });
}

template <class Visit>
void OutOfSight::for_each(const Whereabouts& robot, double now, Visit visit) const {
  const SeenAfter seen_after(robot.pose);
  WaySince way_since(looks_, robot);
  const Drift since = looks_.drift_from_latest_to(robot) + robot.foretold;
  for (const auto& [key, place] : places_) {
    if (!counts(place, now)) continue;
    const Point2 here = seen_after({place.x, place.y});
    const double range = length_of(here);
    const double off = own_size + place.off + place.drifted + way_since.beside(place.look, range) + since.at(range);
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
    moved.drifted = 0.0;
    add_to(places, moved);
  });
  places_ = std::move(places);
  looks_.go_on_in_frame(there);
}

std::vector<KeptPlace> OutOfSight::placed(const Whereabouts& robot, double now) const {
  std::vector<KeptPlace> places;
  for_each(robot, now, [&](const Place& place, const Here& here) {
    places.push_back({here.place, place.z, here.off - own_size, here.look.sensor});
  });
  return places;
}

void OutOfSight::recall(const std::vector<KeptPlace>& places, const Whereabouts& there, double now) {
  std::map<std::size_t, std::uint64_t> looks;
  for (const KeptPlace& one : places) looks[one.sensor] = 0;
  for (auto& [sensor, look] : looks) {
    drift(looks_.take_placed(sensor, there, now), there.pose.place);
    look = looks_.latest();
  }
  const Turn turn(there.pose.heading);
  for (const KeptPlace& one : places) {
    const Point2 at = there.pose.place + turn(one.place);
    const auto height = static_cast<float>(one.height);
    RememberedPlace place{at.x, at.y, height, {height, height}, looks[one.sensor], now, now, one.off, 0.0, believed};
    place.is_recalled = true;
    add_to(places_, place);
  }
  for (const auto& [sensor, look] : looks) looks_.take(sensor, now);  // what it shows by now is not that
}

std::vector<KnownPlace> OutOfSight::resting(const Outlook& camera, const Whereabouts& robot, double now) const {
  std::vector<KnownPlace> places;
  for_each(robot, now, [&](const Place& place, const Here& here) {
    if (place.last_seen - place.first_seen < rests_for || here.off > well_known) return;
    const double off = here.off + limits_.speed * (now - place.last_seen);
    places.push_back(
        {here.place, place.z, camera.seen_from_camera(in_corridor_axes(here.place, place.z)), off, place.last_seen});
  });
  return places;
}

template <class Visit>
void OutOfSight::for_each_unseen(const Whereabouts& robot, double reach, double now, const std::vector<bool>& shows,
                                 Visit visit) const {
  for_each(robot, now, [&](const Place& place, const Here& here) {
    const bool is_shown = shows[here.look.sensor] && looks_.is_latest_of_its_sensor(place.look);
    if (!is_shown && here.range - here.off <= reach) visit(place, here);
  });
}

std::vector<Ring> OutOfSight::rings(const Whereabouts& robot, double reach, double now,
                                    const std::vector<bool>& shows) const {
  std::vector<Ring> rings(displaced.size(), Ring{reach, {}});
  for_each_unseen(robot, reach, now, shows,
                  [&](const Place&, const Here& here) { add_to(rings, here.place, here.off); });
  return rings;
}

/// Who hides where somebody looks is seen as he comes from there.
std::vector<Ring> OutOfSight::rings_at_large(const Whereabouts& robot, double reach, double now,
                                             const std::vector<Eye>& eyes) const {
  std::vector<Ring> rings(displaced.size(), Ring{reach, {}});
  for_each(robot, now, [&](const Place& place, const Here& here) {
    const double off = here.off + limits_.speed * (now - here.look.at);
    if (here.range - off > reach) return;
    const auto watches = [&](const Eye& eye) { return sees_around(eye, here.place); };
    const bool is_watched = std::any_of(eyes.begin(), eyes.end(), watches);
    if (!is_watched && !was_staying(place)) add_to(rings, here.place, off);
  });
  return rings;
}

std::vector<OutOfSight::Rings> OutOfSight::rings_of_each(const Whereabouts& robot, double reach, double now,
                                                         const std::vector<bool>& shows, const AsksFor& asks) const {
  const std::vector<Ring> empty(displaced.size(), Ring{reach, {}});
  std::vector<Rings> of_each(shows.size(), Rings{empty, empty});
  for_each_unseen(robot, reach, now, shows, [&](const Place& place, const Here& here) {
    Rings& rings = of_each[here.look.sensor];
    add_to(rings.all, here.place, here.off);
    if ((place.is_too_near && here.off <= well_known) || asks(here.look.sensor, here.place, place.stands, here.off))
      add_to(rings.asked_for, here.place, here.off);
  });
  return of_each;
}

}  // namespace safety_control_cloud
