// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "plane.hpp"

namespace safety_control_cloud {

struct Segment {
  Point2 from;
  Point2 to;
};

/// [m2] from a point to the nearest of the segment, which must have a length.
inline double squared_distance(const Segment& segment, const Point2& point) {
  const Point2 along = segment.to - segment.from, there = point - segment.from;
  const double share = std::clamp(dot(there, along) / dot(along, along), 0.0, 1.0);
  const Point2 between = there - share * along;
  return dot(between, between);
}

inline double distance(const Segment& segment, const Point2& point) {
  return std::sqrt(squared_distance(segment, point));
}

/// Whether each has its ends clearly on both sides of the other.
inline bool cross_each_other(const Segment& a, const Segment& b) {
  const auto parts = [](const Segment& line, const Segment& other) {
    const Point2 along = line.to - line.from;
    const double from = cross(along, other.from - line.from), to = cross(along, other.to - line.from);
    return std::min(from, to) < -1e-12 && std::max(from, to) > 1e-12;
  };
  return parts(a, b) && parts(b, a);
}

inline double distance(const Segment& a, const Segment& b) {
  if (cross_each_other(a, b)) return 0.0;
  return std::min({distance(a, b.from), distance(a, b.to), distance(b, a.from), distance(b, a.to)});
}

}  // namespace safety_control_cloud
