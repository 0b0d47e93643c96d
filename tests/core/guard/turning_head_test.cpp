// SPDX-License-Identifier: BSD-3-Clause
// A camera on a head that turns, and what it lost before.
#include <gtest/gtest.h>

#include <cmath>

#include "robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

constexpr Twist2 ahead{0.1, 0.0, 0.0}, back{-0.1, 0.0, 0.0};

Settings forgetful() {
  Settings settings = guard_settings();
  settings.memory_distance = 0.0;
  return settings;
}

/// A robot that stands before a post which has come nearer than its camera can see.
struct RobotWithHead : GuardedRobot {
  explicit RobotWithHead(bool has_post = true) : GuardedRobot(forgetful()) {
    if (!has_post) return;
    for (const float ahead : {0.7f, 0.6f, 0.5f, 0.45f, 0.36f}) drives(Scene({post(ahead, 0.0f)}), {});
  }

  double heading = 0.0;  ///< [rad] of its camera

  void looks(const Scene& scene) {
    pass(0.05);
    see(scene.view(), turned_xtion(heading));
  }

  /// At the post, and at a wall that is everywhere else.
  Scene around() const {
    constexpr double camera = -0.087, to_post = 0.36 + camera;  // [m] ahead of what the head turns around
    const double ahead = to_post * std::cos(heading) - camera, right = to_post * std::sin(heading);
    if (ahead < 0.1) return wall;
    return Scene({post(static_cast<float>(ahead), static_cast<float>(right)), post(2.0f, 0.0f, 9.0f)});
  }

  /// By so much, past the post.
  void turns_head(double angle) {
    constexpr int steps = 40;
    for (int i = 0; i < steps; ++i) {
      heading += angle / steps;
      looks(around());
      EXPECT_EQ(wants(ahead).factor, 0.0) << heading << " rad: " << wants(ahead).reason;
    }
  }

  const Scene wall = Scene({post(2.0f, 0.0f, 9.0f)});
};

TEST(TurningHead, WhatItLostStaysWhileItLooksElsewhere) {
  for (const double angle : {0.5, 1.5, -1.5, 3.1}) {
    RobotWithHead robot;
    ASSERT_EQ(robot.wants(ahead).cause, Cause::NearLoss) << robot.wants(ahead).reason;
    robot.turns_head(angle);
    for (int i = 0; i < 20; ++i) robot.looks(robot.around());
    EXPECT_EQ(robot.wants(ahead).factor, 0.0) << angle << " rad: " << robot.wants(ahead).reason;
  }
}

TEST(TurningHead, WhoLooksBackIsFreeToBackOffAndOnceItIsGoneToDriveOn) {
  RobotWithHead robot;
  robot.turns_head(1.5);
  robot.turns_head(-1.5);
  robot.looks(Scene({post(0.36f, 0.0f)}));
  EXPECT_EQ(robot.wants(ahead).cause, Cause::NearLoss) << robot.wants(ahead).reason;
  EXPECT_EQ(robot.wants(back).factor, 1.0) << robot.wants(back).reason;
  for (int i = 0; i < 20; ++i) robot.looks(robot.wall);
  EXPECT_EQ(robot.wants(ahead).factor, 1.0) << robot.wants(ahead).reason;
}

/// The node ends and begins again, and the head looks elsewhere by then.
TEST(TurningHead, WhatItLostBeforeARestartStaysWhileItLooksElsewhere) {
  for (const double angle : {0.02, 0.1, 0.3, 0.6, 1.2, -1.2, 3.1}) {
    RobotWithHead before, robot(false);
    ASSERT_TRUE(robot.control.recall(before.control.remembered()));
    robot.heading = angle;
    for (int i = 0; i < 40; ++i) {
      robot.looks(robot.around());
      EXPECT_EQ(robot.wants(ahead).factor, 0.0) << angle << " rad: " << robot.wants(ahead).reason;
    }
    EXPECT_EQ(RobotWithHead(false).control.recall(robot.control.remembered()), true) << "nor does another restart";
    robot.heading = 0.0;
    for (int i = 0; i < 20; ++i) robot.looks(robot.wall);
    EXPECT_EQ(robot.wants(ahead).factor, 1.0) << angle << " rad: " << robot.wants(ahead).reason;
  }
}

TEST(TurningHead, WhatItLostBeforeARestartIsSeenToHaveGoneFromWhereItLooksNow) {
  for (const double angle : {0.02, 0.03, 0.1, -0.1, 0.3}) {
    RobotWithHead before, robot(false);
    ASSERT_TRUE(robot.control.recall(before.control.remembered()));
    robot.heading = angle;
    for (int i = 0; i < 5; ++i) robot.looks(robot.around());
    EXPECT_EQ(robot.wants(ahead).factor, 0.0) << angle << " rad: " << robot.wants(ahead).reason;
    for (int i = 0; i < 20; ++i) robot.looks(robot.wall);
    EXPECT_EQ(robot.wants(ahead).factor, 1.0) << angle << " rad: " << robot.wants(ahead).reason;
  }
}

TEST(TurningHead, ThatSweepsPastWhereItLookedThenAsksNoOtherPlace) {
  RobotWithHead before, robot(false);
  ASSERT_TRUE(robot.control.recall(before.control.remembered()));
  robot.heading = 1.0;
  robot.turns_head(-1.55);
  for (int i = 0; i < 20; ++i) robot.looks(robot.wall);
  EXPECT_EQ(robot.wants(ahead).factor, 0.0) << robot.wants(ahead).reason;
}

TEST(TurningHead, ThatLooksElsewhereWhenTheNodeEndsTellsWhereItLookedThen) {
  RobotWithHead before, robot(false);
  for (int i = 0; i < 5; ++i) before.looks(Scene({post(0.36f, 0.0f)}));
  before.turns_head(0.4);
  for (int i = 0; i < 20; ++i) before.looks(before.around());
  ASSERT_TRUE(robot.control.recall(before.control.remembered()));
  robot.heading = 0.4;
  for (int i = 0; i < 20; ++i) robot.looks(robot.around());
  EXPECT_EQ(robot.wants(ahead).factor, 0.0) << robot.wants(ahead).reason;
  robot.heading = 0.0;
  for (int i = 0; i < 20; ++i) robot.looks(robot.wall);
  EXPECT_EQ(robot.wants(ahead).factor, 1.0) << robot.wants(ahead).reason;
}

/// What comes near meanwhile, and hides no floor, is remembered too.
TEST(TurningHead, ThatLooksElsewhereAfterARestartGoesOnRemembering) {
  const auto hung = [](float away) {
    return Scene({{away, -0.05f, 0.05f, -0.2f, -0.03f}, {2.0f, -9.0f, 9.0f, -9.0f, floor_y}});
  };
  for (const bool ends_again : {false, true}) {
    RobotWithHead before, robot(false), last(false);
    ASSERT_TRUE(robot.control.recall(before.control.remembered()));
    robot.heading = 0.03;
    for (const float away : {0.7f, 0.6f, 0.5f, 0.45f, 0.36f})
      for (int i = 0; i < 5; ++i) robot.looks(hung(away));
    ASSERT_TRUE(last.control.recall(robot.control.remembered()));
    RobotWithHead& next = ends_again ? last : robot;
    next.heading = 0.0;  // where it sees that the first has gone
    for (int i = 0; i < 20; ++i) next.looks(hung(0.36f));
    EXPECT_EQ(next.wants(ahead).factor, 0.0) << ends_again << ": " << next.wants(ahead).reason;
  }
}

/// And where its corridor has turned with it.
TEST(TurningHead, WhatItLostToItsSideBeforeARestartIsSeenToGoThere) {
  RobotWithHead before(false), robot(false);
  before.heading = robot.heading = 1.2;
  for (const float away : {0.7f, 0.6f, 0.5f, 0.45f, 0.36f}) {
    const Scene scene({post(away, 0.0f)});
    for (int i = 0; i < 10; ++i) before.looks(scene);
  }
  ASSERT_EQ(before.wants(ahead).factor, 0.0) << before.wants(ahead).reason;
  ASSERT_TRUE(robot.control.recall(before.control.remembered()));
  for (int i = 0; i < 20; ++i) robot.looks(Scene({post(0.36f, 0.0f)}));
  EXPECT_EQ(robot.wants(ahead).factor, 0.0) << robot.wants(ahead).reason;
  EXPECT_EQ(robot.wants(ahead).cause, Cause::NearLoss) << robot.wants(ahead).reason;
  for (int i = 0; i < 20; ++i) robot.looks(robot.wall);
  EXPECT_NE(robot.wants(ahead).cause, Cause::NearLoss) << robot.wants(ahead).reason;
  EXPECT_NE(robot.wants(ahead).cause, Cause::WrongView) << robot.wants(ahead).reason;
}

TEST(TurningHead, ResetForgetsWhatItLost) {
  RobotWithHead robot;
  robot.turns_head(1.5);
  EXPECT_EQ(robot.wants(ahead).cause, Cause::WrongView) << robot.wants(ahead).reason;
  robot.control.forget_losses();
  for (int i = 0; i < 3; ++i) robot.looks(robot.wall);
  EXPECT_EQ(robot.wants(ahead).factor, 1.0) << robot.wants(ahead).reason;
}

}  // namespace
}  // namespace safety_control_cloud
