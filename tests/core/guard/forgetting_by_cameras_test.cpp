// SPDX-License-Identifier: BSD-3-Clause
// What a camera does not say, though it looks there: what it repeats, is blind for, or has strays of.
#include <gtest/gtest.h>

#include <random>

#include "../memory/lens.hpp"
#include "robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

/// A picture that only comes again, with a new stamp, was not taken where the robot looks by now.
TEST(Forgetting, WhatACameraRepeatsMakesNothingGo) {
  for (const bool repeats : {false, true}) {
    Settings settings = remembering();
    settings.frozen_clouds = 100;
    RobotWithOdometry robot(settings);
    float noise = 4.0f;  // [m] in one pixel
    const auto looks = [&](Scene scene) {
      scene.set(0, 0, noise += 0.001f);
      robot.passes(0.05, scene);
    };
    const auto turns = [&](double angle) {
      robot.twist = {0.0, 0.0, angle / 0.5};
      for (int i = 0; i < 10; ++i) robot.pose.heading += angle / 10, looks(robot.hall);
      robot.twist = {};
    };
    for (int i = 0; i < 10; ++i) looks(with_post);
    turns(quarter);
    turns(-quarter);
    const Scene past({wall_before(1.5)});
    for (int i = 0; i < 6; ++i) repeats ? robot.passes(0.05, past) : looks(past);
    turns(quarter);
    const Guarded& answer = robot.wants({0.0, -0.5, 0.0});
    EXPECT_EQ(answer.factor < 1.0, repeats) << answer.reason;
  }
}

/// There, what is nearer than it sees lies farther away than its blind range and what that is not sharp by.
TEST(Forgetting, AtTheSideOfAWidePictureACameraIsBlindByDepth) {
  const Lens wide = Lens::of(120.0);
  RobotWithOdometry robot;
  const auto looks = [&](float ahead, double seconds) {
    const auto points = wide.points({{ahead, 0.48f, 0.52f, -0.1f, 0.1f}});
    for (double t = 0.0; t < seconds; t += 0.05) {
      robot.pass(0.05);
      robot.control.note_odometry(robot.now.ros, robot.pose, robot.twist);
      robot.see(wide.view_of_rows(points));
      robot.wants({});
    }
  };
  looks(0.43f, 0.5);
  robot.pose.place.x += 0.05;
  looks(0.38f, 3.0);
  const Guarded& answer = robot.wants({0.3, -0.5, 0.0});
  EXPECT_LT(answer.factor, 0.9) << answer.reason;
  EXPECT_EQ(answer.sensor, "memory");
}

/// As a stereo camera gives them where something is too near for it.
TEST(Forgetting, StrayReturnsDoNotEraseIt) {
  std::mt19937 random(7);
  RobotWithOdometry robot;
  const auto board_at = [](float distance) { return Scene({{distance, -0.3f, 0.3f, -0.3f, 0.25f}}); };
  robot.passes(0.5, board_at(0.6f));
  for (int i = 0; i < 10; ++i) {
    robot.pose.place.x += 0.025;
    robot.passes(0.05, board_at(0.6f - 0.025f * static_cast<float>(i + 1)));  // until it is too near
  }
  for (int i = 0; i < 400; ++i) robot.passes(0.05, board_at(0.35f).stray(0.1, random));
  robot.turns(quarter, robot.hall);
  const Guarded& answer = robot.asked({0.0, -0.7, 0.0});
  EXPECT_LT(answer.factor, 1.0) << answer.reason;
}

}  // namespace
}  // namespace safety_control_cloud
