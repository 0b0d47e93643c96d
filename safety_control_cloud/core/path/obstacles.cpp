// SPDX-License-Identifier: BSD-3-Clause
#include "obstacles.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace safety_control_cloud {
namespace {

/// A return and the cell it lies in, whole numbers that a double holds however far away it is.
struct Placed {
  double column, row;
  Point2 point;

  bool shares_cell(const Placed& other) const { return column == other.column && row == other.row; }
};

struct Box {
  Point2 least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 most{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void include(const Point2& point) {
    least = {std::min(least.x, point.x), std::min(least.y, point.y)};
    most = {std::max(most.x, point.x), std::max(most.y, point.y)};
  }
  Point2 middle() const { return 0.5 * (least + most); }
};

void add(Obstacles& obstacles, const Point2& point, std::uint32_t count) {
  obstacles.points.push_back(point);
  obstacles.counts.push_back(count);
}

}  // namespace

bool Condition::holds_for(const std::vector<Point2>& points, std::size_t i) const {
  if (!counts_) return true;
  known_.resize(points.size(), Known::Not);
  if (known_[i] == Known::Not) known_[i] = counts_(points[i]) ? Known::Counts : Known::CountsNot;
  return known_[i] == Known::Counts;
}

Obstacles reduced(const std::vector<Point2>& points, double cell) {
  Obstacles obstacles;
  std::vector<Placed> placed;
  for (const Point2& point : points) {
    if (is_finite(point)) {
      placed.push_back({std::floor(point.x / cell), std::floor(point.y / cell), point});
    } else {
      add(obstacles, point, 1);
    }
  }
  std::sort(placed.begin(), placed.end(),
            [](const Placed& a, const Placed& b) { return std::tie(a.column, a.row) < std::tie(b.column, b.row); });
  for (auto first = placed.begin(); first != placed.end();) {
    Box box;
    auto last = first;
    for (; last != placed.end() && last->shares_cell(*first); ++last) box.include(last->point);
    add(obstacles, box.middle(), static_cast<std::uint32_t>(last - first));
    obstacles.widening = std::max(obstacles.widening, length_of(box.most - box.middle()));
    first = last;
  }
  return obstacles;
}

Parted parted(const std::vector<Point2>& points, const Outline& outline, double distance) {
  Parted parts;
  for (const Point2& point : points) {
    const bool is_far = outline.signed_distance(point) > distance;
    (is_far ? parts.far : parts.near).push_back(point);
  }
  return parts;
}

}  // namespace safety_control_cloud
