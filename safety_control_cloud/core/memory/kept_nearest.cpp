// SPDX-License-Identifier: BSD-3-Clause
#include "kept_nearest.hpp"

#include <cmath>

#include "../input/point_reader.hpp"

namespace safety_control_cloud {
namespace {

/// A return this little beside the ray of a kept point lies behind it: tan of about 1 degree.
constexpr float behind_slope = 0.02f;
/// An obstacle that is seen this little farther than before has moved away, not vanished [m]: 3 m/s between two clouds.
constexpr double retreat = 0.15;

/// Whether a return lies behind a point that was kept.
bool is_seen_behind(const Point& kept_point, const View& view, const Corridor& corridor, const Gaze& gaze) {
  const Eigen::Vector3f camera = camera_in(gaze).getVector3fMap(), kept = kept_point.getVector3fMap() - camera;
  bool seen = false;
  for_each_point(view, [&](float x, float y, float z) {
    if (!is_return(x, y, z, corridor)) return;
    const Eigen::Vector3f point = placed(x, y, z, gaze).getVector3fMap() - camera;
    const Eigen::Vector3f beside = point - kept * (point.z() / kept.z());
    const float most = behind_slope * point.z();
    seen = seen || (point.z() > kept.z() && std::abs(beside.x()) < most && std::abs(beside.y()) < most);
  });
  return seen;
}

}  // namespace

std::optional<Loss> KeptNearest::judge(const View& view, const Sight& sight, const Corridor& corridor, const Gaze& gaze,
                                       double near_distance) {
  const bool still_there = nearest_ && sight.nearest && sight.nearest->distance() < nearest_->distance() + retreat;
  if (!nearest_ || still_there || is_seen_behind(nearest_->point, view, corridor, gaze)) {
    keep(sight.nearest, near_distance);
    return std::nullopt;
  }
  return Loss{Cause::NearLoss, remembered_at(nearest_->distance()), true,
              "the nearest obstacle has stopped returning and nothing is seen behind it"};
}

void KeptNearest::keep(const std::optional<Obstacle>& nearest, double near_distance) {
  const bool near = nearest && nearest->distance() < near_distance;
  // What is too close to measure lies in no direction, so nothing could ever be seen behind it.
  if (near && nearest->distance() == 0.0) return;
  nearest_ = near ? nearest : std::nullopt;
}

}  // namespace safety_control_cloud
