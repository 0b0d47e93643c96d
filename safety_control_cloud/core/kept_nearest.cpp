// SPDX-License-Identifier: BSD-3-Clause
#include "kept_nearest.hpp"

#include <cmath>

#include "point_reader.hpp"

namespace safety_control_cloud {
namespace {

/// A return this little beside the ray of a kept point lies behind it: tan of about 1 degree.
constexpr float behind_slope = 0.02f;
/// An obstacle that is seen this little farther than before has moved away, not vanished [m].
constexpr double retreat = 0.1;

/// Whether a return lies behind a point that was kept.
bool is_seen_behind(const Point& kept, const View& view, const Corridor& corridor, const Gaze& gaze) {
  bool seen = false;
  for_each_point(view, [&](float x, float y, float z) {
    if (!is_return(x, y, z, corridor)) return;
    const Point point = placed(x, y, z, gaze);
    const float scale = point.z / kept.z, beside = behind_slope * point.z;
    seen = seen || (point.z > kept.z && std::abs(point.x - kept.x * scale) < beside &&
                    std::abs(point.y - kept.y * scale) < beside);
  });
  return seen;
}

}  // namespace

std::optional<Loss> KeptNearest::judge(const View& view, const Sight& sight, const Corridor& corridor, const Gaze& gaze,
                                       double near_distance) {
  if (sight.nearest && sight.nearest->distance() < near_distance) {
    // What is too close to measure lies in no direction, so nothing could ever be seen behind it.
    if (sight.nearest->distance() > 0.0) nearest_ = sight.nearest;
    return std::nullopt;
  }
  if (!nearest_) return std::nullopt;
  const bool moved_away = sight.nearest && sight.nearest->distance() < nearest_->distance() + retreat;
  if (moved_away || is_seen_behind(nearest_->point, view, corridor, gaze)) {
    nearest_.reset();
    return std::nullopt;
  }
  return Loss{Cause::NearLoss, remembered_at(nearest_->distance()), true,
              "the nearest obstacle has stopped returning and nothing is seen behind it"};
}

}  // namespace safety_control_cloud
