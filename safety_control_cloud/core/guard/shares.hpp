// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "../path/twist.hpp"

namespace safety_control_cloud {

/// How one twist differs from another.
inline Twist2 difference(const Twist2& a, const Twist2& b) { return {a.vx - b.vx, a.vy - b.vy, a.w - b.w}; }

/// The c in [0, 1] for which c times `whole` comes nearest to `twist`.
inline double share_in(const Twist2& whole, const Twist2& twist) {
  const auto product = [](const Twist2& a, const Twist2& b) { return a.vx * b.vx + a.vy * b.vy + a.w * b.w; };
  const double size = product(whole, whole);
  return size > 0.0 ? std::clamp(product(twist, whole) / size, 0.0, 1.0) : 0.0;
}

/// [m/s], [rad/s] by which the twists of a motion that goes on may differ from shares of one.
constexpr double unsteady_speed = 0.05, unsteady_turning = 0.15;

/// What of several twists is no share of one motion: a driver's hand is not steady.
class Rest {
 public:
  explicit Rest(const Twist2& whole) : whole_(whole) {}

  /// The share that a twist has in it.
  double add(const Twist2& twist) {
    const double share = share_in(whole_, twist);
    const Twist2 rest = difference(twist, limited(whole_, share));
    most_ = {std::max(most_.vx, std::abs(rest.vx)), std::max(most_.vy, std::abs(rest.vy)),
             std::max(most_.w, std::abs(rest.w))};
    return share;
  }
  bool is_slight() const { return speed_of(most_) <= unsteady_speed && most_.w <= unsteady_turning; }
  const Twist2& most() const { return most_; }

 private:
  Twist2 whole_, most_;
};

}  // namespace safety_control_cloud
