// SPDX-License-Identifier: BSD-3-Clause
#include "out_of_sight.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "cell_key.hpp"
#include "drop_from.hpp"
#include "extents.hpp"
#include "forgetting.hpp"
#include "seen_at.hpp"

namespace safety_control_cloud {
namespace {

constexpr double cell = 0.015, layer = 0.1;   ///< [m] across and up
constexpr std::size_t most = 30000;           ///< places
constexpr std::size_t most_of_a_look = 9630;  ///< of these: of a scan with more beams, the last are not kept
constexpr double kept_share = 0.75;           ///< of them where there are too many
constexpr double stays_for =
    1.0;  ///< [s] between two looks that show the same place: whoever stands so long is not about to walk

/// Of the key of a place that is shown once more, where what was there may be elsewhere: it goes as any other.
constexpr std::uint64_t elsewhere = std::uint64_t{1} << 63U;

std::uint64_t key_of(const Point2& place, double height) { return key_of_cell(place, cell, height, layer); }

}  // namespace

/// Beside what has the same cell.
void OutOfSight::put(const Place& place, Places& places) {
  const std::uint64_t key = key_of({place.x, place.y}, place.z);
  if (places.emplace(key, place).second) return;
  const auto [beside, is_new] = places.emplace(key | elsewhere, place);
  if (!is_new) beside->second.off = std::max(beside->second.off, place.off);
}

void OutOfSight::limit(OutOfSightLimits limits) {
  limits_ = std::move(limits);
  drop_from(places_, [this](const auto& entry) { return !limits_.vicinity.holds(entry.second.z); });
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
  drop_from(places_, [&](auto& entry) { return forgetting.has_gone(entry.second); });
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
  drop_from(places_, [&](const auto& entry) { return !shown_by(entry.second, now); });
}

/// For all that one look may show: of too many, the farthest are forgotten.
void OutOfSight::make_room(const Point2& robot) {
  if (places_.size() + most_of_a_look <= most) return;
  const auto range = [&](const Place& place) { return length_of(Point2{place.x, place.y} - robot); };
  std::vector<double> ranges;
  for (const auto& [key, place] : places_) ranges.push_back(range(place));
  const auto last = ranges.begin() + static_cast<std::ptrdiff_t>(kept_share * static_cast<double>(ranges.size()));
  std::nth_element(ranges.begin(), last, ranges.end());
  drop_from(places_, [&](const auto& entry) { return range(entry.second) > *last; });
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
    put(place, places_);
  }
  for (const auto& [sensor, look] : looks) looks_.take(sensor, now);  // what it shows by now is not that
}

}  // namespace safety_control_cloud
