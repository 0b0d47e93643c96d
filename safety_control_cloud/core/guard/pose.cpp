// SPDX-License-Identifier: BSD-3-Clause
#include "pose.hpp"

#include <algorithm>

namespace safety_control_cloud {

Obstacles seen_after(const Pose2& way, const Obstacles& before) {
  const SeenAfter seen_after(way);
  Obstacles moved{{}, before.counts, 0.0};
  for (const Point2& point : before.points) moved.points.push_back(seen_after(point));
  return moved;
}

double half_of_gap(std::vector<Pose2> ways, double distance) {
  std::sort(ways.begin(), ways.end(),
            [&](const Pose2& a, const Pose2& b) { return displacement(a, distance) < displacement(b, distance); });
  double gap = 0.0;
  for (std::size_t i = 1; i < ways.size(); ++i)
    gap = std::max(gap, displacement(between(ways[i - 1], ways[i]), distance));
  return 0.5 * gap;
}

}  // namespace safety_control_cloud
