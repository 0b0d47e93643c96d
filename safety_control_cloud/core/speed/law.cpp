// SPDX-License-Identifier: BSD-3-Clause
#include "law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace safety_control_cloud {
namespace {

/// Of a s^2 + b s = c with a, c >= 0, in the form in which nothing cancels and that also holds at a = 0.
double positive_root(double a, double b, double c) {
  const double root = std::sqrt(b * b + 4.0 * a * c);
  if (b < 0.0) return (root - b) / (2.0 * a);
  return b + root > 0.0 ? 2.0 * c / (b + root) : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<std::string> problems_in(const Law& law) {
  std::vector<std::string> problems;
  const auto check = [&](const char* name, double value, bool may_be_zero) {
    if (std::isfinite(value) && (value > 0.0 || (may_be_zero && value == 0.0))) return;
    problems.push_back(std::string(name) + (may_be_zero ? " must be finite and not negative" : " must be positive"));
  };
  check("sensor_period", law.sensor_period, true);
  check("latency", law.latency, true);
  check("base_reaction", law.base_reaction, true);
  check("linear_deceleration", law.linear_deceleration, false);
  check("angular_deceleration", law.angular_deceleration, false);
  check("obstacle_speed", law.obstacle_speed, true);
  check("escape_speed", law.escape_speed, true);
  check("noise", law.noise, true);
  if (law.min_points < 1) problems.emplace_back("min_points must be at least 1");
  return problems;
}

Response response_to(const Law& law, const Age& age, const Twist2& twist) {
  const double delay = law.latency + law.base_reaction;
  return {delay, std::max(age.now, law.sensor_period) + delay,
          std::max(speed_of(twist) / law.linear_deceleration, std::abs(twist.w) / law.angular_deceleration)};
}

double approach(const Law& law, const Age& age, const Response& response, double factor, double share) {
  const double goes_on = std::max(response.reaction, age.at_next_look + response.delay) + factor * response.braking;
  const double brakes = age.now + response.delay + share * response.braking;
  return law.obstacle_speed * std::max(goes_on, brakes);
}

double greatest_factor(double time, const Response& response, double share) {
  const auto& [delay, reaction, braking] = response;
  if (!(time > 0.0) || time < stopping_time(share, delay, braking)) return 0.0;
  if (time >= stopping_time(1.0, reaction, braking) && share <= 1.0) return 1.0;
  const double from_rest = positive_root(0.5 * braking, reaction, time);
  if (share <= from_rest) return std::min(1.0, from_rest);
  const double slowing =
      positive_root(braking, reaction - delay - share * braking, time - stopping_time(share, delay, braking));
  return std::min({1.0, share, slowing});
}

double least_time(double factor, const Response& response, double share) {
  const auto& [delay, reaction, braking] = response;
  if (factor >= share) return stopping_time(factor, reaction, braking);
  const double to_stop = stopping_time(share, delay, braking);
  const double to_slow = to_stop + factor * (reaction - delay - share * braking) + factor * factor * braking;
  return std::max(to_stop, std::min(to_slow, stopping_time(share, reaction, braking)));
}

}  // namespace safety_control_cloud
