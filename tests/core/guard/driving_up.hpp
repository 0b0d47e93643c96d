// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot_with_odometry.hpp"

namespace safety_control_cloud {

/// A robot that drives up to what is so far ahead of its camera until that is too near for it.
inline void drives_up(RobotWithOdometry& robot, Scene (*at)(float)) {
  constexpr float first = 0.8f, last = 0.36f, step = 0.01f;
  for (float ahead = first; ahead >= last; ahead -= step) {
    robot.passes(0.05, at(ahead));
    robot.pose.place.x += double{step};
  }
  robot.pose.place.x -= double{step};
  robot.passes(2.0, at(last));  // until it stands
}

inline Scene post_at(float ahead) { return Scene({post(ahead, 0.02f, 0.06f)}); }
inline Scene board_at(float ahead) { return Scene({{ahead, -0.3f, 0.3f, -0.3f, 0.05f}}); }

inline Scene wall_at(float ahead) { return Scene({{ahead, -9.0f, 9.0f, -9.0f, floor_y}}); }

inline const Twist2 ahead{0.3, 0.0, 0.0}, about{0.0, 0.0, 1.0}, away{-0.05, 0.0, 0.3};

}  // namespace safety_control_cloud
