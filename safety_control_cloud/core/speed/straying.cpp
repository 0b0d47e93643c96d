// SPDX-License-Identifier: BSD-3-Clause
#include "straying.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

/// Magnitudes of a twist and the times in which its axes brake.
struct Axes {
  double speed, turning;             ///< [m/s], [rad/s]
  double linear_time, angular_time;  ///< [s]
};

Axes axes_of(const Law& law, const Twist2& twist) {
  const double speed = speed_of(twist), turning = std::abs(twist.w);
  return {speed, turning, speed / law.linear_deceleration, turning / law.angular_deceleration};
}

Twist2 beside(const Twist2& under_way, const Twist2& wanted, double share) {
  return {under_way.vx - share * wanted.vx, under_way.vy - share * wanted.vy, under_way.w - share * wanted.w};
}

/// [m] by which a point strays if one of two axes takes longer by `difference` [s] for the same change of factor.
double out_of_step(const Axes& wanted, double change, double difference, double lever) {
  return 0.5 * change * difference * std::min(wanted.speed, wanted.turning * lever);
}

double widening_for(const Outline& outline, const Response& response, const Axes& wanted, const Axes& beside,
                    double share, const Factors& factors) {
  const double most = std::max(factors.most, share);
  const double change = std::max(std::abs(factors.least - share), std::abs(factors.most - share));
  const double apart = factors.in_step ? 0.0 : std::abs(wanted.linear_time - wanted.angular_time);
  const double to_shed = beside.linear_time + beside.angular_time;
  const double braking = most * std::max(wanted.linear_time, wanted.angular_time);
  const double lever = outline.turning_reach() + most * wanted.speed * (response.reaction + 0.5 * braking);
  const double while_braking = outline.turning_reach() + 0.25 * most * most * wanted.speed * wanted.linear_time;

  const auto integral = [&](double amount, double wanted_time, double time) {
    return amount * (response.delay + 0.5 * (change + most) * wanted_time + time);
  };
  return out_of_step(wanted, most, most * apart, while_braking) + out_of_step(wanted, change, change * apart, lever) +
         0.5 * (change * std::min(wanted.speed, wanted.turning * lever) * to_shed) +
         0.5 * most * (wanted.speed * beside.linear_time + wanted.turning * lever * beside.angular_time) +
         integral(beside.speed, wanted.linear_time, beside.linear_time) +
         lever * integral(beside.turning, wanted.angular_time, beside.angular_time);
}

}  // namespace

Straying straying(const Outline& outline, const Law& law, const Response& response, const Twist2& under_way,
                  const Twist2& wanted, const Factors& factors) {
  const Axes axes = axes_of(law, wanted);
  const double linear_share = dot(linear(under_way), linear(wanted)) / (axes.speed * axes.speed);
  const double angular_share = under_way.w / wanted.w;
  Straying best{0.0, std::numeric_limits<double>::infinity()};
  for (const double share : {linear_share, angular_share, 0.0}) {
    if (!(share >= 0.0 && std::isfinite(share))) continue;
    const Axes rest = axes_of(law, beside(under_way, wanted, share));
    const double widening = widening_for(outline, response, axes, rest, share, factors);
    if (widening < best.widening) best = {share, widening};
  }
  return best;
}

}  // namespace safety_control_cloud
