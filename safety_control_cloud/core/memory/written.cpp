// SPDX-License-Identifier: BSD-3-Clause
#include "written.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "likeness.hpp"

namespace safety_control_cloud {
namespace {

constexpr double period = 0.25;                           ///< [s]
constexpr double at_latest = 1.0;                         ///< [s] of what has not changed
constexpr float same_range = 0.02f, same_middle = 0.04f;  ///< [m] what differs by less has not
constexpr double same_size = 1.25;

bool is_near(const Remembered& thing, float near) { return !thing.lost.empty() || thing.seen.nearest < near; }

}  // namespace

bool Written::Told::is_as(const Told& other) const {
  const auto [less, more] = std::minmax(size, other.size);
  return std::abs(nearest - other.nearest) < same_range && more <= same_size * less &&
         (middle - other.middle).norm() < same_middle && show_the_same(camera, other.camera);
}

bool Written::is_any_near_in(const std::vector<Remembered>& things, float near) {
  return std::any_of(things.begin(), things.end(), [=](const Remembered& thing) { return is_near(thing, near); });
}

/// A kerb is written though none is near.
bool Written::is_due(bool lost, bool any_near, double now) const {
  return lost != is_any_lost_ || any_near != is_any_near_ || now - written_at_ >= period;
}

/// Of what is seen; none: something is lost, or nothing is near.
std::vector<Written::Told> Written::told_of(const std::vector<Remembered>& things, float near) {
  std::vector<Told> told;
  for (const Remembered& thing : things) {
    if (!is_near(thing, near)) continue;
    if (!thing.lost.empty() || !thing.is_seen()) return {};
    const std::vector<Spot>& spots = thing.seen.spots;
    told.push_back({thing.seen.nearest, middle_of(spots), thing.seen.size, spots.front().camera});
  }
  return told;
}

/// Whether the text says that already, and for no longer than it may without being written anew.
bool Written::says(const std::vector<Told>& told, double now) const {
  const auto same = [](const Told& one, const Told& other) { return one.is_as(other); };
  return !told.empty() && now - written_at_ < at_latest &&
         std::equal(told.begin(), told.end(), told_.begin(), told_.end(), same);
}

void Written::write(Kept kept, float near) {
  const auto is_far = [=](const Remembered& thing) { return !is_near(thing, near); };
  kept.things.erase(std::remove_if(kept.things.begin(), kept.things.end(), is_far), kept.things.end());
  text_ = to_text(kept);
}

}  // namespace safety_control_cloud
