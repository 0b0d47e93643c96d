// SPDX-License-Identifier: BSD-3-Clause
#include "corridor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "point_reader.hpp"

namespace safety_control_cloud {
namespace {

bool is_return(float x, float y, float z, const Corridor& corridor) {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && z > corridor.range_min;
}

bool is_inside(float x, float y, const Corridor& corridor) {
  return x >= corridor.x_min && x <= corridor.x_max && y >= corridor.y_min && y <= corridor.y_max;
}

}  // namespace

bool is_too_close(float x, float y, float z, const Corridor& corridor) {
  if (z != -std::numeric_limits<float>::infinity()) return false;
  const bool left_or_right = std::isfinite(x) && (x < corridor.x_min || x > corridor.x_max);
  const bool above_or_below = std::isfinite(y) && (y < corridor.y_min || y > corridor.y_max);
  return !left_or_right && !above_or_below;
}

std::optional<Obstacle> nearest_of(std::size_t too_close, const Cloud& inside, const Corridor& corridor) {
  if (too_close >= corridor.min_points) return Obstacle{Point(0.0f, 0.0f, 0.0f)};
  const std::size_t rank = corridor.min_points - too_close - 1;
  if (rank >= inside.size()) return std::nullopt;

  std::vector<float> depths(inside.size());
  std::transform(inside.begin(), inside.end(), depths.begin(), [](const Point& point) { return point.z; });
  const auto ranked = depths.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(depths.begin(), ranked, depths.end());
  return Obstacle{*std::find_if(inside.begin(), inside.end(), [&](const Point& point) { return point.z == *ranked; })};
}

Sight look(const CloudView& cloud, const Corridor& corridor, Crop crop) {
  Sight sight;
  Cloud inside;
  Point nearest(0.0f, 0.0f, std::numeric_limits<float>::infinity());
  const bool points_wanted = crop == Crop::Keep || corridor.min_points > 1;
  for_each_point(cloud, [&](float x, float y, float z) {
    if (is_too_close(x, y, z, corridor)) ++sight.too_close;
    if (!is_return(x, y, z, corridor)) return;
    ++sight.returns;
    if (!is_inside(x, y, corridor)) return;
    ++sight.inside;
    if (z < nearest.z) nearest = Point(x, y, z);
    if (points_wanted) inside.push_back(Point(x, y, z));
  });
  sight.total = cloud.size();
  if (corridor.min_points > 1 || sight.too_close > 0) {
    sight.nearest = nearest_of(sight.too_close, inside, corridor);
  } else if (sight.inside > 0) {
    sight.nearest = Obstacle{nearest};
  }
  if (crop == Crop::Keep) sight.crop.reset(new Cloud(std::move(inside)));
  return sight;
}

}  // namespace safety_control_cloud
