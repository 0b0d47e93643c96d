// SPDX-License-Identifier: BSD-3-Clause
#include "footprint.hpp"

#include <algorithm>
#include <cstddef>

#include "segment.hpp"

namespace safety_control_cloud {
namespace {

constexpr double nearest_corners = 1e-4;  // [m]

/// 1 for the first, as people count.
std::string corner(std::size_t index) { return "corner " + std::to_string(index + 1); }
std::string side(std::size_t index, std::size_t count) {
  return "the side from " + corner(index) + " to " + corner((index + 1) % count);
}

bool is_near_enough(const Point2& point) {
  return std::abs(point.x) <= farthest_corner && std::abs(point.y) <= farthest_corner;
}

/// Sides that meet in a corner: whether one runs back along the other.
bool folds_back(const Segment& first, const Segment& second) {
  return distance(first, second.to) < nearest_corners || distance(second, first.from) < nearest_corners;
}

void check_sides(const std::vector<Point2>& corners, std::vector<std::string>& problems) {
  const std::size_t count = corners.size();
  const auto at = [&](std::size_t i) { return Segment{corners[i % count], corners[(i + 1) % count]}; };
  for (std::size_t i = 0; i < count; ++i) {
    if (length_of(at(i).to - at(i).from) < nearest_corners) {
      problems.push_back(side(i, count) + " has no length");
      return;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (folds_back(at(i), at(i + 1))) problems.push_back("the polygon folds back at " + corner((i + 1) % count));
    for (std::size_t j = i + 2; j < count && (i > 0 || j + 1 < count); ++j) {
      if (distance(at(i), at(j)) < nearest_corners)
        problems.push_back(side(i, count) + " and " + side(j, count) + " meet");
    }
  }
}

void check_polygon(const Footprint& footprint, std::vector<std::string>& problems) {
  const std::vector<Point2>& corners = footprint.polygon;
  if (footprint.radius != 0.0) problems.emplace_back("the footprint is either a polygon or a radius");
  if (corners.size() < 3) problems.emplace_back("the polygon must have at least 3 corners");
  if (corners.size() > most_corners)
    problems.push_back("the polygon must have at most " + std::to_string(most_corners) + " corners");
  const bool near = std::all_of(corners.begin(), corners.end(), is_near_enough);
  if (!near) problems.emplace_back("each corner must be finite and within 100 m of base_frame's origin");
  if (problems.empty()) check_sides(corners, problems);
}

}  // namespace

std::vector<std::string> problems_in(const Footprint& footprint) {
  std::vector<std::string> problems;
  if (!footprint.polygon.empty()) {
    check_polygon(footprint, problems);
  } else if (!(footprint.radius > 0.0 && footprint.radius <= farthest_corner)) {
    problems.emplace_back("the footprint must have a polygon, or a radius of more than 0 and at most 100 m");
  }
  if (!(footprint.margin >= 0.0 && footprint.margin <= most_margin))
    problems.emplace_back("margin must lie between 0 and 100 m");
  return problems;
}

}  // namespace safety_control_cloud
