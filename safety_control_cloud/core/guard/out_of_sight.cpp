// SPDX-License-Identifier: BSD-3-Clause
#include "out_of_sight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "../memory/pixels.hpp"

namespace safety_control_cloud {
namespace {

constexpr double cell = 0.015, layer = 0.1;      ///< [m] across and up
constexpr std::size_t columns = 107, rows = 80;  ///< of a picture that are looked at, at most
constexpr std::size_t most = 30000;              ///< places
constexpr std::uint8_t believed = 2;             ///< looks that show a place, or what is behind it
/// [m] Places are told apart by these; what may be off by more than the last is as the one that is off the most.
constexpr std::array<double, 8> displaced = {0.015, 0.02, 0.03, 0.045, 0.07, 0.12, 0.2, 0.4};
constexpr double well_known = 0.2;   ///< [m] what may be off by more explains nothing that is lost
constexpr double absent_for = 1.25;  ///< [s] without a return where there would be one
constexpr double rests_for = 0.3;    ///< [s] between two looks that show the same place
constexpr double own_size = 0.01;    ///< [m] by which a return may lie beside the place of its cell

std::uint64_t key_of(const Point2& place, double height) {
  const auto part = [](double value) { return static_cast<std::uint64_t>(std::llround(value)) & 0x1fffffU; };
  return part(place.x / cell) << 42U | part(place.y / cell) << 21U | part(height / layer);
}

std::size_t step_for(std::size_t size, std::size_t wanted) { return (size + wanted - 1) / wanted; }

/// Where a place of base_frame lies in the corridor's axes.
Point in_axes(const Point2& place, float height) {
  return Point(static_cast<float>(-place.y), -height, static_cast<float>(place.x));
}

}  // namespace

void OutOfSight::note(std::size_t sensor, const Look& look, const Pose2& pose, double now) {
  travel(pose);
  if (!remembers()) return places_.clear();
  latest_[sensor] = ++look_;
  const auto is_over = [&](const Place& place) { return now - place.seen_at > limits_.time; };
  for (auto it = places_.begin(); it != places_.end();) it = is_over(it->second) ? places_.erase(it) : std::next(it);
  const SeenAt seen_at(look.reading, look.view);
  if (!seen_at.can_tell()) return;
  keep_near(sensor, look, pose, now);
  drop_what_has_gone(look, seen_at, pose, now);
}

void OutOfSight::travel(const Pose2& pose) {
  if (pose_) {
    const Pose2 way = between(*pose_, pose);
    distance_ += length_of(way.place);
    angle_ += std::abs(way.heading);
  }
  pose_ = pose;
}

void OutOfSight::keep_near(std::size_t sensor, const Look& look, const Pose2& pose, double now) {
  const Pixels pixels(look.view, look.outlook.corridor.range_min);
  const bool is_scan = std::holds_alternative<ScanView>(look.reading);
  const std::size_t across = is_scan ? 1 : step_for(pixels.width(), columns), down = step_for(pixels.height(), rows);
  const Turn turn(pose.heading);
  PixelRow row;
  for (std::size_t r = 0; r < pixels.height(); r += down) {
    pixels.read(r, across, look.outlook, row);
    for (std::size_t i = 0; i < row.z.size(); ++i) {
      const Point2 place{row.z[i], -row.x[i]};
      const float height = -row.y[i];
      const bool counts = height >= limits_.bottom && height <= limits_.top &&
                          dot(place, place) <= limits_.distance * limits_.distance;  // of NaN, false
      if (!counts || is_own(limits_.self, place.x, place.y, height)) continue;
      keep(sensor, pose.place + turn(place), height, now);
    }
  }
}

void OutOfSight::keep(std::size_t sensor, const Point2& place, float height, double now) {
  const std::uint64_t key = key_of(place, height);
  const auto found = places_.find(key);
  if (found == places_.end() && places_.size() >= most) return;
  Place kept{
      static_cast<float>(place.x), static_cast<float>(place.y), height, now, now, distance_, angle_, sensor, look_};
  if (found == places_.end()) {
    places_.emplace(key, kept);
    return;
  }
  const Place& before = found->second;
  const int looks = before.looks + (before.look == look_ ? 0 : 1);
  kept.first_seen = before.first_seen;
  kept.looks = static_cast<std::uint8_t>(std::min<int>(looks, believed));
  found->second = kept;
}

void OutOfSight::drop_what_has_gone(const Look& look, const SeenAt& seen_at, const Pose2& pose, double now) {
  const SeenAfter seen_after(pose);
  for (auto it = places_.begin(); it != places_.end();) {
    Place& place = it->second;
    if (place.look == look_) {
      ++it;
      continue;
    }
    const Point2 here = seen_after({place.x, place.y});
    const Point seen_from_there = look.outlook.seen_from_camera(in_axes(here, place.z));
    const bool is_measured = seen_from_there.getVector3fMap().norm() >= static_cast<float>(look.measures_from);
    it = has_gone(place, seen_at(seen_from_there), is_measured, now) ? places_.erase(it) : std::next(it);
  }
}

/// What is shown has its place anew, from this look. What a sensor could measure and does not is kept for a while: some
/// things return from one side only.
bool OutOfSight::has_gone(Place& place, AtPlace seen, bool is_measured, double now) const {
  if (seen == AtPlace::NotThere || (seen == AtPlace::Nothing && !is_measured)) {
    place.absent_since.reset();
    return false;
  }
  if (seen == AtPlace::Shown) return true;
  if (seen == AtPlace::Behind) ++place.away;
  if (!place.absent_since) place.absent_since = now;
  return place.away >= believed || now - *place.absent_since >= absent_for;
}

bool OutOfSight::counts(const Place& place, double now) const {
  return place.looks >= believed && now - place.seen_at <= limits_.time;
}

bool OutOfSight::holds_any(double now) const {
  return std::any_of(places_.begin(), places_.end(), [&](const auto& entry) { return counts(entry.second, now); });
}

template <class Visit>
void OutOfSight::for_each(const Pose2& pose, double now, Visit visit) const {
  const SeenAfter seen_after(pose);
  const Pose2 since = pose_ ? between(*pose_, pose) : Pose2{};
  const double distance = distance_ + length_of(since.place), angle = angle_ + std::abs(since.heading);
  for (const auto& [key, place] : places_) {
    if (!counts(place, now)) continue;
    const Point2 here = seen_after({place.x, place.y});
    const double range = length_of(here);
    const double off = own_size + limits_.drift * (distance - place.distance + (angle - place.angle) * range);
    visit(place, Here{here, range, off});
  }
}

std::vector<KnownPlace> OutOfSight::resting(const Outlook& camera, const Pose2& pose, double now) const {
  std::vector<KnownPlace> places;
  for_each(pose, now, [&](const Place& place, const Here& here) {
    if (place.seen_at - place.first_seen < rests_for || here.off > well_known) return;
    const double off = here.off + limits_.speed * (now - place.seen_at);
    places.push_back({here.place, camera.seen_from_camera(in_axes(here.place, place.z)), off});
  });
  return places;
}

std::vector<Ring> OutOfSight::rings(const Pose2& pose, double reach, double now, const std::vector<bool>& shows) const {
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < displaced.size(); ++i) rings.push_back({reach, {}});
  for_each(pose, now, [&](const Place& place, const Here& here) {
    const bool is_shown = shows[place.sensor] && latest_.at(place.sensor) == place.look;
    if (is_shown || here.range - here.off > reach) return;
    const auto fits = std::lower_bound(displaced.begin(), displaced.end() - 1, here.off);
    Ring& ring = rings[static_cast<std::size_t>(fits - displaced.begin())];
    ring.obstacles.points.push_back(here.place);
    ring.obstacles.widening = std::max(ring.obstacles.widening, here.off);
    ++ring.returns;
  });
  return rings;
}

}  // namespace safety_control_cloud
