// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "pose.hpp"
#include "whereabouts.hpp"

namespace safety_control_cloud {

/// How a base follows what it is told, at its slowest.
struct Following {
  double delay;                 ///< [s] from a command to its effect
  double linear_deceleration;   ///< [m/s2]
  double angular_deceleration;  ///< [rad/s2]
};

/// Axis by axis.
struct TwistRange {
  Twist2 least, most;
};

TwistRange spanning(const TwistRange& a, const Twist2& twist);

/// Where a robot may be of which one knows only between which twists it moved. An axis may take up whatever it aims at
/// at once, and lets go of what it does as slowly as it can.
class Extremes {
 public:
  /// It goes on for `time` [s], and may aim at all of this.
  void go_on(const TwistRange& aims, double time, const Following& following);

  /// Amid all of them, and who does all that he can, or as little, axis by axis.
  Whereabouts whereabouts(double drift) const { return {amid_, {corners_.begin(), corners_.end()}, drift}; }

 private:
  static constexpr std::size_t corners = 8;  ///< of three axes

  TwistRange twist_{};
  Pose2 amid_{};
  std::array<Pose2, corners> corners_{};
};

}  // namespace safety_control_cloud
