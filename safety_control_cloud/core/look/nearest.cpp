// SPDX-License-Identifier: BSD-3-Clause
#include "nearest.hpp"

#include <algorithm>
#include <limits>

namespace safety_control_cloud {
namespace {

std::vector<float> depths_of(const Cloud& cloud) {
  std::vector<float> depths(cloud.size());
  std::transform(cloud.begin(), cloud.end(), depths.begin(), [](const Point& point) { return point.z; });
  return depths;
}

}  // namespace

Obstacle too_close_to_measure() { return {Point(0.0f, 0.0f, 0.0f)}; }

std::optional<std::size_t> rank_of(std::size_t too_close, std::size_t min_points) {
  if (too_close >= min_points) return std::nullopt;
  return min_points - too_close - 1;
}

float ranked(std::vector<float> values, std::size_t rank) {
  if (rank >= values.size()) return std::numeric_limits<float>::infinity();
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

float ranked_z(const Cloud& cloud, std::size_t rank) { return ranked(depths_of(cloud), rank); }

Obstacle first_at(const Cloud& cloud, float z) {
  return {*std::find_if(cloud.begin(), cloud.end(), [&](const Point& point) { return point.z == z; })};
}

std::optional<Obstacle> nearest_of(std::size_t too_close, const Cloud& inside, std::size_t min_points) {
  const auto rank = rank_of(too_close, min_points);
  if (!rank) return too_close_to_measure();
  if (*rank >= inside.size()) return std::nullopt;
  return first_at(inside, ranked_z(inside, *rank));
}

}  // namespace safety_control_cloud
