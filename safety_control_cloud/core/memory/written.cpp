// SPDX-License-Identifier: BSD-3-Clause
#include "written.hpp"

#include <algorithm>
#include <utility>

namespace safety_control_cloud {
namespace {

constexpr double period = 0.25;  // [s]

bool is_near(const Remembered& thing, float near) { return !thing.lost.empty() || thing.seen.nearest < near; }

/// Whether all of it was seen along this axis: it is written down so.
bool lies_along(const Axis& axis, const Remembered& thing) {
  return thing.lost.empty() || are_same(axis, *thing.lost.front().axis, same_axis);
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
  if (read_) {
    kept.things.insert(kept.things.end(), read_->things.begin(), read_->things.end());
    kept.blind_range = std::max(kept.blind_range, read_->blind_range);
    kept.more = kept.more || (is_any_low(*read_) && is_any_low(kept));
    if (is_any_low(*read_)) kept.low = read_->low, kept.axis = read_->axis;
  }
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
  if (!read_) return std::nullopt;
  Kept taken{read_->width, read_->height, std::exchange(read_->blind_range, 0.0f), {}, {}};
  auto& things = read_->things;
  const auto others =
      std::partition(things.begin(), things.end(), [&](const Remembered& thing) { return lies_along(axis, thing); });
  taken.things.assign(things.begin(), others);
  things.erase(things.begin(), others);
  if (!read_->axis || are_same(axis, *read_->axis, same_axis)) taken.low.swap(read_->low);
  if (!waits()) read_.reset();
  return taken;
}

void Written::turn_corridor(double angle) {
  if (!read_) return;
  if (read_->axis) read_->axis = axis_turned(*read_->axis, angle);
  for (Remembered& thing : read_->things)
    for (Spot& spot : thing.lost) spot.axis = axis_turned(*spot.axis, angle);
}

}  // namespace safety_control_cloud
