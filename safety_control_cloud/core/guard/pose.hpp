// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "../input/cloud.hpp"
#include "../path/obstacles.hpp"
#include "../path/twist.hpp"

namespace safety_control_cloud {

/// A place of the robot and where it looks, in some frame that rests; or how far it went, in its own frame of before.
struct Pose2 {
  Point2 place;
  double heading = 0.0;  ///< [rad]
};

/// By an angle [rad], of which the sine and cosine are asked for once for many points.
class Turn {
 public:
  explicit Turn(double angle) : cosine_(std::cos(angle)), sine_(std::sin(angle)) {}
  Point2 operator()(const Point2& point) const {
    return {cosine_ * point.x - sine_ * point.y, sine_ * point.x + cosine_ * point.y};
  }

 private:
  double cosine_, sine_;
};

inline Point2 turned(const Point2& point, double angle) { return Turn(angle)(point); }

/// How one comes from one pose to another, as the first sees it.
inline Pose2 between(const Pose2& from, const Pose2& to) {
  return {turned(to.place - from.place, -from.heading), to.heading - from.heading};
}

/// Where one is who went on so from there.
inline Pose2 beyond(const Pose2& from, const Pose2& way) {
  return {from.place + turned(way.place, from.heading), from.heading + way.heading};
}

/// A share of a way that is not long.
inline Pose2 shared(const Pose2& way, double share) { return {share * way.place, share * way.heading}; }

/// A place of base_frame in the corridor's axes: x right, y down, z ahead.
inline Point in_corridor_axes(const Point2& place, double height) {
  return Point(static_cast<float>(-place.y), static_cast<float>(-height), static_cast<float>(place.x));
}

/// How far a twist leads in `time` [s].
inline Pose2 way_of(const Twist2& twist, double time) {
  return {moved({}, {-twist.vx, -twist.vy, -twist.w}, time), twist.w * time};
}

/// That of a part which is fixed there on who has this twist, in its own axes.
inline Twist2 twist_of_part(const Twist2& twist, const Pose2& part) {
  const Point2 velocity = linear(twist) + twist.w * turned_left(part.place), own = turned(velocity, -part.heading);
  return {own.x, own.y, twist.w};
}

/// Where resting points stand in base_frame once the robot has gone this way.
class SeenAfter {
 public:
  explicit SeenAfter(const Pose2& way) : place_(way.place), back_(-way.heading) {}
  Point2 operator()(const Point2& point) const { return back_(point - place_); }

 private:
  Point2 place_;
  Turn back_;
};

/// The same of obstacles; their widening is left to whoever asks.
Obstacles seen_after(const Pose2& way, const Obstacles& before);

/// [m] that a point at this distance from who turns by an angle [rad] moves at most, seen from him: to the other side.
inline double displacement_by_turn(double angle, double distance) { return std::min(std::abs(angle), 2.0) * distance; }

/// [m] that a point at this distance from the robot moves at most, seen from it.
inline double displacement(const Pose2& way, double distance) {
  return length_of(way.place) + displacement_by_turn(way.heading, distance);
}

/// [m] that such a point may be from where the nearest of the ways has it, if the true one lies between two that follow
/// each other by their size.
double half_of_gap(std::vector<Pose2> ways, double distance);

}  // namespace safety_control_cloud
