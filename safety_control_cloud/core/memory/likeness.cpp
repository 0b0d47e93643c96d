// SPDX-License-Identifier: BSD-3-Clause
#include "likeness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/points.hpp"

namespace safety_control_cloud {
namespace {

/// As many spots of a thing tell which one it is.
constexpr std::size_t enough_spots = 24;
/// A surface that is seen again lies no farther behind what was seen of it [m], noise and all.
constexpr float as_near = 0.02f;

using Vector = Eigen::Vector3f;

/// Of spots, to be asked about many at a time.
class Places {
 public:
  explicit Places(const std::vector<Spot>& spots) : size_(spots.size()), coordinates_(3 * size_) {
    float* to = coordinates_.data();
    for (const Spot& spot : spots) {
      to[0] = spot.point.x, to[size_] = spot.point.y, to[2 * size_] = spot.point.z;
      ++to;
    }
  }

  points::PixelsOfRow all() const {
    const float* const x = coordinates_.data();
    return {x, x + size_, x + 2 * size_, size_};
  }

 private:
  std::size_t size_;
  std::vector<float> coordinates_;
};

}  // namespace

Eigen::Vector3f middle_of(const std::vector<Spot>& spots) {
  Vector sum = Vector::Zero();
  float all = 0.0f;
  for (const Spot& spot : spots) sum += spot.share * spot.point.getVector3fMap(), all += spot.share;
  return sum / all;
}

Likeness likeness_of(const std::vector<Spot>& before, const Thing& now) {
  constexpr float far = farthest_step * farthest_step;
  const Places seen(now.spots);
  std::size_t close = 0, asked = 0;
  double closeness = 0.0;
  for (std::size_t i = 0; i < before.size(); i += 1 + before.size() / enough_spots, ++asked) {
    const float least = points::least_square(seen.all(), before[i].point, far);
    close += least < far;
    closeness += 1.0 - std::sqrt(double{least}) / double{farthest_step};
  }
  const double all = static_cast<double>(std::max<std::size_t>(1, asked));
  return {static_cast<double>(close) / all, closeness / all};
}

/// Judged by what is seen aside of it least far.
void note_what_went_alone(std::vector<Spot>& before, const Thing& now, float near) {
  if (before.empty() || now.spots.empty()) return;
  const Vector way = middle_of(now.spots) - middle_of(before);
  float farthest = 0.0f;
  for (const Spot& seen : now.spots) farthest = std::max(farthest, seen.point.z);
  for (Spot& spot : before) {
    if (spot.point.z >= near) continue;
    const Vector there = spot.point.getVector3fMap() + way;
    const bool may_be_behind = farthest - there.z() > as_near;  // not of most of a wall straight ahead
    float least = std::numeric_limits<float>::infinity(), behind = 0.0f;
    for (std::size_t i = 0; may_be_behind && i < now.spots.size(); ++i) {
      const Vector off = now.spots[i].point.getVector3fMap() - there;
      const float aside = off.head<2>().squaredNorm();
      if (aside < least) least = aside, behind = off.z();
    }
    spot.went_alone = behind > as_near;
  }
}

}  // namespace safety_control_cloud
