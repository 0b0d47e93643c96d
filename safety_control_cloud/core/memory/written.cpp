// SPDX-License-Identifier: BSD-3-Clause
#include "written.hpp"

#include <algorithm>
#include <utility>

namespace safety_control_cloud {
namespace {

constexpr double period = 0.25;  // [s]

bool is_near(const Remembered& thing, float near) { return !thing.lost.empty() || thing.seen.nearest < near; }

/// Of a head that turned since, a spot that is asked about along another axis than the text tells of.
bool is_any_elsewhere(const std::vector<Remembered>& things, const std::optional<Axis>& axis) {
  const auto is_elsewhere = [&](const Spot& spot) {
    return spot.axis && axis && !are_same(*spot.axis, *axis, same_axis);
  };
  const auto is_any = [&](const std::vector<Spot>& spots) {
    return std::any_of(spots.begin(), spots.end(), is_elsewhere);
  };
  return std::any_of(things.begin(), things.end(),
                     [&](const Remembered& thing) { return is_any(thing.lost) || is_any(thing.seen.spots); });
}

}  // namespace

bool Written::is_any_near_in(const std::vector<Remembered>& things, float near) {
  return std::any_of(things.begin(), things.end(), [=](const Remembered& thing) { return is_near(thing, near); });
}

/// A kerb is written though none is near.
bool Written::is_due(bool lost, bool any_near, double now) const {
  return lost != is_any_lost_ || any_near != is_any_near_ || now - written_at_ >= period;
}

void Written::write(Kept kept, float near) {
  const auto is_far = [=](const Remembered& thing) { return !is_near(thing, near); };
  kept.things.erase(std::remove_if(kept.things.begin(), kept.things.end(), is_far), kept.things.end());
  kept.more = kept.more || is_any_elsewhere(kept.things, kept.axis);
  text_ = to_text(kept);
}

bool Written::read(const std::string& text) {
  auto kept = kept_in(text);
  if (!kept) return false;
  *this = Written();
  text_ = text;
  read_ = std::move(kept);
  return true;
}

/// In the picture of a camera that looks along another axis, each spot would be asked about at another's place.
std::optional<Kept> Written::taken_up(const Axis& axis) {
  const bool looks_so = read_ && (!read_->axis || are_same(axis, *read_->axis, same_axis));
  return looks_so ? std::exchange(read_, std::nullopt) : std::nullopt;
}

void Written::turn_corridor(double angle) {
  if (read_ && read_->axis) read_->axis = axis_turned(*read_->axis, angle);
}

}  // namespace safety_control_cloud
