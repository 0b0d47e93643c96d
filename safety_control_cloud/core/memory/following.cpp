// SPDX-License-Identifier: BSD-3-Clause
#include "following.hpp"

#include <algorithm>
#include <utility>

#include "hanging.hpp"
#include "likeness.hpp"

namespace safety_control_cloud {
namespace {

/// Of a thing of which as much is still seen, nothing is lost.
constexpr double same_size = 0.85;

void drop_what_came_along(std::vector<Spot>& spots) {
  const auto came_along = [](const Spot& spot) { return !spot.went_alone; };
  spots.erase(std::remove_if(spots.begin(), spots.end(), came_along), spots.end());
}

}  // namespace

std::vector<Thing> follow(std::vector<Remembered>& things, std::vector<Thing> seen, float near, const Shown& shown) {
  std::vector<Thing> before;
  for (Remembered& thing : things) {
    before.push_back(std::exchange(thing.seen, Thing{}));
    thing.seen.size = before.back().size;  // as it was seen last
  }
  std::vector<const std::vector<Spot>*> remembered;
  for (const Thing& thing : before) remembered.push_back(&thing.spots);
  for (const Remembered& thing : things) remembered.push_back(&thing.lost);
  keep_hanging(seen, remembered);
  keep_standing(seen, remembered);
  for (Thing& now : seen) {
    std::size_t best = things.size();
    const double least = now.at_border ? 0.05 : 0.25;  // what leaves the corridor may lose most of it in one step
    double most = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (before[i].spots.empty() || things[i].is_seen()) continue;
      const Likeness alike = likeness_of(before[i].spots, now);
      const double as_large = std::min(1.0, now.size / before[i].size);
      const double all_in_all = as_large * (alike.share + alike.closeness);
      if (alike.share * as_large > least && all_in_all > most) best = i, most = all_in_all;
    }
    if (best == things.size()) {
      things.emplace_back();
      before.emplace_back();
    }
    Remembered& thing = things[best];
    const double size_before = before[best].size;
    const bool same =
        now.size > same_size * size_before && size_before > same_size * now.size && now.size > same_size * thing.size;
    if (same) note_what_went_alone(before[best].spots, now, near);
    if (same && thing.lost.empty()) drop_what_came_along(before[best].spots);
    thing.size = std::max(thing.size, now.size);
    thing.at_border = now.at_border;
    thing.is_slight = now.is_slight;
    thing.stood = now.stands || (thing.stood && !now.hangs);
    // What is left of it at a border may show no foot: a post that slides out of the corridor still stands. But what is
    // seen below it says that it does not.
    for (Spot& spot : now.spots) {
      spot.stands = spot.stands || (thing.stood && spot.foot_unseen);
      spot.turning = shown.turning;
      spot.picture = shown.picture;
    }
    thing.seen = std::move(now);
    thing.freed = 0.0;
    thing.vanished = false;
    ++thing.clouds;
  }
  return before;
}

}  // namespace safety_control_cloud
