// SPDX-License-Identifier: BSD-3-Clause
#include "written.hpp"

#include <algorithm>
#include <utility>

namespace safety_control_cloud {
namespace {

constexpr double period = 0.25;  // [s]

bool is_near(const Remembered& thing, float near) { return !thing.lost.empty() || thing.seen.nearest < near; }

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
  text_ = to_text(kept);
}

}  // namespace safety_control_cloud
