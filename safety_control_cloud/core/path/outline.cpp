// SPDX-License-Identifier: BSD-3-Clause
#include "outline.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace safety_control_cloud {
namespace {

const Footprint& checked(const Footprint& footprint) {
  std::string all;
  for (const std::string& problem : problems_in(footprint)) all += (all.empty() ? "" : "; ") + problem;
  if (!all.empty()) throw std::invalid_argument(all);
  return footprint;
}

double twice_the_area(const std::vector<Point2>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) sum += cross(corners[i], corners[(i + 1) % corners.size()]);
  return sum;
}

std::vector<Point2> anticlockwise(std::vector<Point2> corners) {
  if (twice_the_area(corners) < 0.0) std::reverse(corners.begin(), corners.end());
  return corners;
}

Side side_of(const Point2& from, const Point2& to) {
  const Point2 along = (1.0 / length_of(to - from)) * (to - from);
  return {{from, to}, along, -1.0 * turned_left(along)};
}

/// Whether a ray from the point forward crosses the side, which owns its lower end and not its upper one.
bool is_crossed_forward(const Segment& side, const Point2& point) {
  if ((side.from.y > point.y) == (side.to.y > point.y)) return false;
  const bool is_left_of_side = cross(side.to - side.from, point - side.from) > 0.0;
  return is_left_of_side == (side.to.y > side.from.y);
}

}  // namespace

Outline::Outline(const Footprint& footprint) : radius_(checked(footprint).radius), margin_(footprint.margin) {
  const std::vector<Point2> corners = anticlockwise(footprint.polygon);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sides_.push_back(side_of(corners[i], corners[(i + 1) % corners.size()]));
    reach_ = std::max(reach_, length_of(corners[i]));
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Side& before = sides_[(i + sides_.size() - 1) % sides_.size()];
    if (cross(before.along, sides_[i].along) > -touch) round_corners_.push_back(corners[i]);
  }
  if (corners.empty()) {
    round_corners_.push_back({});
    reach_ = radius_;
  }
}

double Outline::signed_distance(const Point2& point) const {
  if (sides_.empty()) return length_of(point) - radius_;
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (const Side& side : sides_) {
    nearest = std::min(nearest, squared_distance(side.segment, point));
    inside ^= is_crossed_forward(side.segment, point);
  }
  return inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

/// The speed of a point grows with its distance from the centre of rotation, and a corner is farthest from it.
double fastest_point(const Outline& outline, const Twist2& twist) {
  if (outline.sides().empty()) return speed_of(twist) + std::abs(twist.w) * outline.radius();
  double fastest = 0.0;
  for (const Side& side : outline.sides())
    fastest = std::max(fastest, length_of(linear(twist) + twist.w * turned_left(side.segment.from)));
  return fastest;
}

}  // namespace safety_control_cloud
