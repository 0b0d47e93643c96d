// SPDX-License-Identifier: BSD-3-Clause
#include "corridor.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "point_reader.hpp"

namespace safety_control_cloud {

bool is_too_close(float x, float y, float z, const Corridor& corridor, const Gaze& gaze) {
  if (z != -std::numeric_limits<float>::infinity()) return false;
  if (gaze.placement) return true;
  const bool left_or_right = std::isfinite(x) && !corridor.spans(x);
  const bool above_or_below = std::isfinite(y) && (y < corridor.y_min || y > corridor.y_max);
  return !left_or_right && !above_or_below;
}

std::uint16_t remembered(const Point& point, const Corridor& corridor, float near_distance) {
  const bool near = point.z > 0.0f && point.z < near_distance;
  if (!near || !corridor.spans(point.x)) return PixelMemory::elsewhere;
  if (point.y > corridor.y_max) return PixelMemory::ground_code(point.z);
  return point.y >= corridor.y_min ? PixelMemory::near_code(point.z) : PixelMemory::elsewhere;
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

Sight look(const CloudView& cloud, const Corridor& corridor, const Gaze& gaze) {
  Sight sight;
  Cloud inside;  // in the corridor's axes, for the min_points-th of them
  Cloud::Ptr crop(gaze.crop == Crop::Keep ? new Cloud : nullptr);
  Point nearest(0.0f, 0.0f, std::numeric_limits<float>::infinity());
  std::uint16_t* pixel = gaze.memory ? gaze.memory->pixels.data() : nullptr;

  for_each_point(cloud, [&](float x, float y, float z) {
    std::uint16_t* const memory = pixel ? pixel++ : nullptr;
    if (is_too_close(x, y, z, corridor, gaze)) ++sight.too_close;
    if (!is_return(x, y, z, corridor)) {
      if (!memory) return;
      *memory = PixelMemory::code_of(*memory);
      sight.lost += PixelMemory::is_near(*memory);
      return;
    }
    ++sight.returns;
    const Point point = placed(x, y, z, gaze);
    if (memory) {
      *memory = static_cast<std::uint16_t>(remembered(point, corridor, gaze.memory->distance) | PixelMemory::now);
    }
    if (!is_inside(point, corridor)) return;
    ++sight.inside;
    if (point.z < nearest.z) nearest = point;
    if (corridor.min_points > 1) inside.push_back(point);
    if (crop) crop->push_back(Point(x, y, z));
  });

  sight.total = cloud.size();
  if (corridor.min_points > 1 || sight.too_close > 0) {
    sight.nearest = nearest_of(sight.too_close, inside, corridor);
  } else if (sight.inside > 0) {
    sight.nearest = Obstacle{nearest};
  }
  sight.crop = crop;
  return sight;
}

}  // namespace safety_control_cloud
