// SPDX-License-Identifier: BSD-3-Clause
// What a camera does not say, though it looks there: what it repeats, is blind for, or has strays of.
#include <gtest/gtest.h>

#include <random>

#include "../../../safety_control_cloud/core/guard/forgetting.hpp"
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

/// Too near for the camera, it is a hole in what is seen behind it. Asked only about its place and about the two that
/// lie farthest aside, the camera would look past it on either side.
TEST(Forgetting, APostMayStandAnywhereBetweenTheFarthestPlacesToWhichOdometryMayHaveSlipped) {
  const Vicinity vicinity{0.0, 0.6, 1.5};
  const Lens lens = Lens::of(60.0);
  const float ahead = 0.38f, half_of_it = 0.008f;  // [m]
  for (int off = -6; off <= 7; ++off) {            // [cm] to the right of its place; 7: it has gone
    std::vector<Board> boards{{2.5f, -3.0f, 3.0f, -2.0f, 2.0f}};
    const auto middle = 0.01f * static_cast<float>(off);
    if (off <= 6) boards.push_back({ahead, middle - half_of_it, middle + half_of_it, -0.5f, 0.5f});
    const auto points = lens.points(boards);
    const Reading reading = lens.view_of_rows(points);
    const Look look{reading, std::get<CloudView>(reading), Outlook(Corridor{}), 0.0, 0.4};
    const SeenAt seen_at(look, vicinity);
    LooksTaken looks;
    for (const double now : {0.0, 0.1}) looks.take_placed(0, Whereabouts{}, now, now);
    const Whereabouts robot;
    Forgetting forgetting(look, seen_at, looks, robot, Drift{0.06, 0.0}, 0.1, 30.0);
    RememberedPlace place{ahead, 0.0, 0.1f, {0.0, 0.5}, 1, 0.0, 0.0};
    for (int i = 1; i < believed; ++i) EXPECT_FALSE(forgetting.has_gone(place));
    EXPECT_EQ(forgetting.has_gone(place), off == 7) << off << " cm";
  }
}

}  // namespace
}  // namespace safety_control_cloud
