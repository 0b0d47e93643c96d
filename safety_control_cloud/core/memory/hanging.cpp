// SPDX-License-Identifier: BSD-3-Clause
#include "hanging.hpp"

#include <algorithm>

#include "likeness.hpp"

namespace safety_control_cloud {
namespace {

using Spots = std::vector<const std::vector<Spot>*>;

/// Whether something farther away was seen below it.
bool hung(const Spot& spot) { return !spot.stands && !spot.foot_unseen; }

bool any_hung(const Spots& remembered) {
  return std::any_of(remembered.begin(), remembered.end(),
                     [](const auto* spots) { return std::any_of(spots->begin(), spots->end(), hung); });
}

/// Of several that are as near, any.
template <class Is>
bool nearest_is(const Point& place, const Spots& remembered, Is is) {
  float least = farthest_step * farthest_step;
  bool any = false;
  for (const auto* spots : remembered) {
    for (const Spot& spot : *spots) {
      const float away = squared_distance(spot.point, place);
      if (away > least || (away == least && any)) continue;
      least = away;
      any = is(spot);
    }
  }
  return any;
}

}  // namespace

void keep_hanging(std::vector<Thing>& seen, const Spots& remembered) {
  if (!any_hung(remembered)) return;
  for (Thing& now : seen) {
    for (Spot& spot : now.spots) {
      const bool may_hang = spot.foot_unseen || (spot.stands && spot.overhang > 0.0f);
      spot.hung_before = may_hang && nearest_is(spot.point, remembered, hung);
      if (spot.hung_before) spot.stands = spot.foot_unseen = false;
    }
  }
}

void keep_standing(std::vector<Thing>& seen, const Spots& remembered) {
  const auto stood = [](const Spot& spot) { return spot.stands; };
  for (Thing& now : seen) {
    const auto was_standing = [&](const Spot& spot) { return nearest_is(spot.point, remembered, stood); };
    if (now.is_edge && std::all_of(now.spots.begin(), now.spots.end(), was_standing)) now.stands = true;
  }
}

}  // namespace safety_control_cloud
