// SPDX-License-Identifier: BSD-3-Clause
#include "extremes.hpp"

#include <algorithm>

namespace safety_control_cloud {
namespace {

double rising(double from, double to, double most) { return to <= from ? to : std::min(to, from + most); }

double falling(double from, double to, double most) { return -rising(-from, -to, most); }

Twist2 halfway(const Twist2& a, const Twist2& b) {
  return {0.5 * (a.vx + b.vx), 0.5 * (a.vy + b.vy), 0.5 * (a.w + b.w)};
}

Twist2 lesser(const Twist2& a, const Twist2& b) {
  return {std::min(a.vx, b.vx), std::min(a.vy, b.vy), std::min(a.w, b.w)};
}

Twist2 greater(const Twist2& a, const Twist2& b) {
  return {std::max(a.vx, b.vx), std::max(a.vy, b.vy), std::max(a.w, b.w)};
}

Twist2 corner(const TwistRange& range, std::size_t which) {
  const auto of = [&](std::size_t axis) -> const Twist2& {
    return (which >> axis & 1U) != 0 ? range.most : range.least;
  };
  return {of(0).vx, of(1).vy, of(2).w};
}

}  // namespace

TwistRange spanning(const TwistRange& a, const Twist2& twist) {
  return {lesser(a.least, twist), greater(a.most, twist)};
}

void Extremes::go_on(const TwistRange& aims, double time, const Following& following) {
  const double linear = following.linear_deceleration * time, angular = following.angular_deceleration * time;
  const TwistRange then{lesser(twist_.least, aims.least), greater(twist_.most, aims.most)};
  twist_.least = {rising(then.least.vx, aims.least.vx, linear), rising(then.least.vy, aims.least.vy, linear),
                  rising(then.least.w, aims.least.w, angular)};
  twist_.most = {falling(then.most.vx, aims.most.vx, linear), falling(then.most.vy, aims.most.vy, linear),
                 falling(then.most.w, aims.most.w, angular)};
  const TwistRange meanwhile{halfway(then.least, twist_.least), halfway(then.most, twist_.most)};
  amid_ = beyond(amid_, way_of(halfway(meanwhile.least, meanwhile.most), time));
  for (std::size_t i = 0; i < corners; ++i) corners_[i] = beyond(corners_[i], way_of(corner(meanwhile, i), time));
}

}  // namespace safety_control_cloud
