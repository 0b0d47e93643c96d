// SPDX-License-Identifier: BSD-3-Clause
#include "twist.hpp"

namespace safety_control_cloud {
namespace {

constexpr double absurd = 1e6;  // [m/s], [rad/s]

/// sin(x) / x, which is 1 at 0.
double sine_over(double x) { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

}  // namespace

bool is_sound(const Twist2& twist) {
  return std::abs(twist.vx) <= absurd && std::abs(twist.vy) <= absurd && std::abs(twist.w) <= absurd;
}

Twist2 limited(const Twist2& twist, double factor) {
  if (factor >= 1.0) return twist;
  if (!(factor > 0.0)) return {};
  return {factor * twist.vx, factor * twist.vy, factor * twist.w};
}

/// The chord of the circle: its length is that of the arc times sin(half the angle) / (half the angle), and it leaves
/// the point turned by half the angle. Neither needs the centre, which is infinitely far at w = 0.
Point2 moved(const Point2& point, const Twist2& twist, double time) {
  const double half = 0.5 * twist.w * time;
  const Point2 ahead = apparent_velocity(twist, point);
  const double chord = time * sine_over(half);
  return point + chord * (std::cos(half) * ahead - std::sin(half) * turned_left(ahead));
}

}  // namespace safety_control_cloud
