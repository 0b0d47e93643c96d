// SPDX-License-Identifier: BSD-3-Clause
// What is kept, as it lies around the robot.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "out_of_sight.hpp"

namespace safety_control_cloud {
namespace {

/// [m] Places are told apart by these; what may be off by more than the last is as the one that is off the most.
constexpr std::array<double, 12> displaced = {0.015, 0.02, 0.03, 0.045, 0.07, 0.12, 0.2, 0.3, 0.45, 0.7, 1.0, 1.5};
constexpr double rests_for = 0.3;  ///< [s] between two looks that show the same place
constexpr double one_step = 0.1;   ///< [m] more than anything goes from one look to the next, or is wide
constexpr double own_size = 0.01;  ///< [m] by which a return may lie beside the place of its cell

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
  Places places;
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
    put(moved, places);
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
