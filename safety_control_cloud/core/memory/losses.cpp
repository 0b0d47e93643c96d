// SPDX-License-Identifier: BSD-3-Clause
#include "losses.hpp"

#include <algorithm>
#include <limits>

namespace safety_control_cloud {
namespace {

/// Where a loss is at the nearest [m].
double nearest_place(const Loss& loss) { return loss.whole || !loss.obstacle ? 0.0 : loss.obstacle->distance(); }

/// In the corridor, and near enough to count.
bool is_lost(const Remembered& thing, const Spot& spot, const Outlook& outlook, const KeptWithin& within) {
  const Point place = spot.place();
  return outlook.corridor.holds(place) && (thing.vanished || place.z - outlook.camera().z < within.distance);
}

}  // namespace

std::vector<LostSpot> lost_spots(const std::vector<Remembered>& things, const Outlook& outlook,
                                 const KeptWithin& within) {
  std::vector<LostSpot> spots;
  for (const Remembered& thing : things)
    for (const Spot& spot : thing.lost)
      if (is_lost(thing, spot, outlook, within)) spots.push_back({spot.point, spot.picture});
  return spots;
}

std::optional<Loss> nearest_loss(const std::vector<Remembered>& things, const Outlook& outlook,
                                 const KeptWithin& within) {
  std::optional<Loss> nearest;
  for (const Remembered& thing : things) {
    double size = 0.0, distance = std::numeric_limits<double>::infinity();
    for (const Spot& spot : thing.lost) {
      if (!is_lost(thing, spot, outlook, within)) continue;
      size += double{spot.share};
      distance = std::min(distance, double{spot.place().z});
    }
    if (size == 0.0) continue;
    const bool may_be_nearer = distance - outlook.camera().z < within.may_be_nearer;
    const bool whole = !thing.is_seen() || 2.0 * size > thing.size || may_be_nearer;
    const Loss loss{Cause::NearLoss, remembered_at(distance), whole,
                    "an obstacle has stopped returning and nothing is seen behind it"};
    nearest = nearer(nearest, loss);
  }
  return nearest;
}

std::optional<Loss> nearer(const std::optional<Loss>& one, const std::optional<Loss>& other) {
  if (!one || !other) return one ? one : other;
  return nearest_place(*one) <= nearest_place(*other) ? one : other;
}

bool is_in_sight(const Loss& loss) { return loss.cause == Cause::LowObstacle && !loss.whole; }

}  // namespace safety_control_cloud
