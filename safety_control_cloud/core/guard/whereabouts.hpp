// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "pose.hpp"

namespace safety_control_cloud {

/// By how much a way may be off.
struct Drift {
  double place = 0.0, heading = 0.0;  ///< [m], [rad]

  double at(double range) const { return place + displacement_by_turn(heading, range); }  ///< [m] so far away
};

inline Drift operator+(const Drift& a, const Drift& b) { return {a.place + b.place, a.heading + b.heading}; }

/// How fast a base may go [m/s] and turn [rad/s], by what it was told of late.
struct Fastest {
  double speed = std::numeric_limits<double>::infinity(), turning = std::numeric_limits<double>::infinity();
};

/// Where the robot is, in a frame that rests.
struct Whereabouts {
  Pose2 pose;
  std::vector<Pose2> or_else = {};  ///< where it may be instead: the true one lies among all of them
  double drift = 0.0;               ///< [m/m], [rad/rad] by which the way there may be off
  Drift unexplained = {};           ///< of the way there, since some moment: what no motion explains
  Drift foretold = {};              ///< by how much it may be elsewhere, since nobody has told of that moment yet
};

/// Of the way between them.
inline Drift drift_between(const Whereabouts& a, const Whereabouts& b) {
  const Pose2 way = between(a.pose, b.pose);
  return {b.drift * length_of(way.place) + std::abs(b.unexplained.place - a.unexplained.place),
          b.drift * std::abs(way.heading) + std::abs(b.unexplained.heading - a.unexplained.heading)};
}

}  // namespace safety_control_cloud
