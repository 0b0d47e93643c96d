// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plane.hpp"

namespace safety_control_cloud {

/// A constant motion in the plane, as in geometry_msgs/Twist.
struct Twist2 {
  double vx = 0.0;  ///< [m/s] forward
  double vy = 0.0;  ///< [m/s] to the left
  double w = 0.0;   ///< [rad/s] turning left
};

inline Point2 linear(const Twist2& twist) { return {twist.vx, twist.vy}; }
inline double speed_of(const Twist2& twist) { return length_of(linear(twist)); }  ///< [m/s] of base_frame's origin

/// Finite, and slow enough (a million m/s or rad/s) that its squares stay so.
bool is_sound(const Twist2& twist);

/// The twist as a whole times a factor in [0, 1], so that the path keeps its shape. At 1 it is equal in every bit; what
/// is no factor (NaN, negative) is standing.
Twist2 limited(const Twist2& twist, double factor);

/// What a resting point at `point` does in base_frame at this moment [m/s]. Its magnitude never changes while the twist
/// lasts: the point moves on a line, or on a circle around the centre of rotation.
inline Point2 apparent_velocity(const Twist2& twist, const Point2& point) {
  return -1.0 * (linear(twist) + twist.w * turned_left(point));
}

/// Where a resting point stands in base_frame after `time` [s] of the twist.
Point2 moved(const Point2& point, const Twist2& twist, double time);

}  // namespace safety_control_cloud
