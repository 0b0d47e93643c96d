// SPDX-License-Identifier: BSD-3-Clause
#include "escape.hpp"

#include <algorithm>

namespace safety_control_cloud {
namespace {

constexpr int most_steps = 2000;  // 10 cm in steps of a twentieth of a millimetre

/// [m] by which a point may be nearer at the end: a robot that is told to slide along a wall does so nearly.
double nearer_at_the_end(double way, double allowance) { return touch + std::min(way / 50.0, allowance / 8.0); }

}  // namespace

double allowance_for(double signed_distance, double noise) {
  return signed_distance > 0.0 ? std::min(noise, 0.5 * signed_distance) : noise;
}

bool comes_nearer(const Outline& outline, const Twist2& twist, const Point2& point, double duration, double allowance) {
  const double now = outline.signed_distance(point), floor = now - allowance;
  const double speed = length_of(apparent_velocity(twist, point));
  double time = 0.0, distance = now;
  for (int step = 0; step < most_steps; ++step) {
    if (!(distance - floor >= 0.5 * allowance && allowance > 0.0)) return true;
    time += (distance - floor) / speed;
    if (!(time < duration)) {
      const double end = outline.signed_distance(moved(point, twist, duration));
      return !(end >= now - nearer_at_the_end(speed * duration, allowance));
    }
    distance = outline.signed_distance(moved(point, twist, time));
  }
  return true;
}

}  // namespace safety_control_cloud
