// SPDX-License-Identifier: BSD-3-Clause
#include "likeness.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

/// As many spots of a thing tell which one it is.
constexpr std::size_t enough_spots = 24;

}  // namespace

Likeness likeness_of(const std::vector<Spot>& before, const Thing& now) {
  constexpr float far = farthest_step * farthest_step;
  std::size_t close = 0, asked = 0;
  double closeness = 0.0;
  for (std::size_t i = 0; i < before.size(); i += 1 + before.size() / enough_spots, ++asked) {
    float least = far;
    for (const Spot& spot : now.spots) least = std::min(least, squared_distance(before[i].point, spot.point));
    close += least < far;
    closeness += 1.0 - std::sqrt(double{least}) / double{farthest_step};
  }
  const double all = static_cast<double>(std::max<std::size_t>(1, asked));
  return {static_cast<double>(close) / all, closeness / all};
}

}  // namespace safety_control_cloud
