// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "../path/twist.hpp"

namespace safety_control_cloud {

/// A place of the robot and where it looks, in some frame that rests; or how far it went, in its own frame of before.
struct Pose2 {
  Point2 place;
  double heading = 0.0;  ///< [rad]
};

inline Point2 turned(const Point2& point, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * point.x - s * point.y, s * point.x + c * point.y};
}

/// How one comes from one pose to another, as the first sees it.
inline Pose2 between(const Pose2& from, const Pose2& to) {
  return {turned(to.place - from.place, -from.heading), to.heading - from.heading};
}

/// Where one is who went on so from there.
inline Pose2 beyond(const Pose2& from, const Pose2& way) {
  return {from.place + turned(way.place, from.heading), from.heading + way.heading};
}

/// How far a twist leads in `time` [s].
inline Pose2 way_of(const Twist2& twist, double time) {
  return {moved({}, {-twist.vx, -twist.vy, -twist.w}, time), twist.w * time};
}

/// Where a resting point stands in base_frame once the robot has gone this way.
inline Point2 seen_after(const Pose2& way, const Point2& point) { return turned(point - way.place, -way.heading); }

/// [m] that a point at this distance from the robot moves at most, seen from it.
inline double displacement(const Pose2& way, double distance) {
  return length_of(way.place) + std::abs(way.heading) * distance;
}

}  // namespace safety_control_cloud
