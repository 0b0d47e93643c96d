// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/guard_control.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "../../safety_control_cloud/core/guard/directions.hpp"
#include "guard/guarded_robot.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::uint8_t forward = directions[0].bit, backward = directions[1].bit, turning_left = directions[4].bit;

bool equal_bits(const Command& a, const Command& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST(GuardControl, NothingIsGivenBeforeAnythingWasSeen) {
  GuardedRobot robot;
  const Guarded& answer = robot.wants({0.2, 0.0, 0.0});
  EXPECT_TRUE(equal_bits(answer.given, {}));
  EXPECT_EQ(answer.cause, Cause::NoCloud);
  EXPECT_TRUE(answer.stuck);
}

TEST(GuardControl, ASafeCommandPassesEqualInEveryBit) {
  GuardedRobot robot;
  robot.see(Scene({post(2.5f, 0.3f)}));
  Command odd;
  odd.linear = {0.1 + 0.2, -0.0, 1e-300};
  odd.angular = {-0.0, 5e-324, 0.1 / 3.0};
  const Guarded& answer = robot.is_told(odd);
  EXPECT_TRUE(equal_bits(answer.given, odd)) << answer.reason;
  EXPECT_EQ(answer.factor, 1.0);
  EXPECT_FALSE(answer.stuck);
}

TEST(GuardControl, BeforeAWallACommandIsScaledAsAWhole) {
  GuardedRobot robot;
  const Guarded& answer = robot.drives(Scene({wall_before(0.4)}), {0.6, 0.0, 0.3});
  EXPECT_GT(answer.factor, 0.0);
  EXPECT_LT(answer.factor, 1.0);
  EXPECT_DOUBLE_EQ(answer.given.linear[0], answer.factor * 0.6);
  EXPECT_DOUBLE_EQ(answer.given.angular[2], answer.factor * 0.3);
  ASSERT_TRUE(answer.point);
  EXPECT_NEAR(answer.point->x, 0.578, 0.05);
  EXPECT_EQ(answer.sensor, "cloud");
}

TEST(GuardControl, WhatComesAfterADoubtfulCloudIsZero) {
  GuardedRobot robot;
  ASSERT_EQ(robot.drives(Scene(), {0.3, 0.0, 0.0}).factor, 1.0);
  robot.control.see(Unreadable{"no field x"}, {robot.now.ros, xtion(), "camera", ""}, robot.now);
  EXPECT_EQ(robot.wants({0.3, 0.0, 0.0}).cause, Cause::Unreadable);
  EXPECT_EQ(robot.wants({-0.1, 0.0, 0.0}).factor, 0.0) << "backward too";
  EXPECT_EQ(robot.wants({-0.1, 0.0, 0.0}).open, 0);
  EXPECT_EQ(robot.drives(Scene(), {0.3, 0.0, 0.0}).factor, 1.0);
}

TEST(GuardControl, SilenceStopsIt) {
  GuardedRobot robot;
  robot.drives(Scene(), {0.3, 0.0, 0.0});
  robot.pass(0.51);
  const Guarded& answer = robot.wants({0.3, 0.0, 0.0});
  EXPECT_EQ(answer.cause, Cause::Silent);
  EXPECT_EQ(answer.factor, 0.0);
}

TEST(GuardControl, ABlindCameraAfterSilenceIsNoReasonToBackOff) {
  GuardedRobot robot;
  robot.drives(Scene(), {0.3, 0.0, 0.0});
  robot.pass(1.0);
  robot.wants({0.3, 0.0, 0.0});
  EXPECT_EQ(robot.drives(Scene({wall_before(0.05)}), {-0.1, 0.0, 0.0}).factor, 0.0);
}

TEST(GuardControl, WithoutATransformItStands) {
  GuardedRobot robot;
  robot.drives(Scene(), {0.3, 0.0, 0.0});
  const Scene scene;
  robot.see(scene.view(), NoTransform{"nobody says"});
  EXPECT_EQ(robot.wants({0.3, 0.0, 0.0}).cause, Cause::NoTransform);
  robot.see(scene.view(), OpticalFrame{});
  EXPECT_EQ(robot.wants({0.3, 0.0, 0.0}).cause, Cause::NoTransform);
}

TEST(GuardControl, TheOlderACloudTheLessIsGiven) {
  GuardedRobot robot;
  double before = robot.drives(Scene({wall_before(0.5)}), {0.6, 0.0, 0.0}).factor;
  ASSERT_GT(before, 0.0);
  for (int i = 0; i < 8; ++i) {
    robot.pass(0.06);
    const double factor = robot.wants({0.6, 0.0, 0.0}).factor;
    EXPECT_LE(factor, before);
    before = factor;
  }
  EXPECT_LT(before, 0.3);
}

TEST(GuardControl, AnOldCommandIsNone) {
  GuardedRobot robot;
  EXPECT_EQ((robot.see(Scene()), robot.control.answer(robot.now)).cause, Cause::NoCommand);
  ASSERT_EQ(robot.drives(Scene(), {0.3, 0.0, 0.0}).factor, 1.0);
  robot.pass(0.49);
  robot.see(Scene());
  EXPECT_EQ(robot.control.answer(robot.now).factor, 1.0);
  robot.pass(0.02);
  const Guarded& answer = robot.control.answer(robot.now);
  EXPECT_EQ(answer.cause, Cause::NoCommand);
  EXPECT_TRUE(equal_bits(answer.given, {}));
  EXPECT_FALSE(answer.stuck) << "nobody wants anything";
}

TEST(GuardControl, TellsWhenACommandHoldsNoMore) {
  Settings patient = guard_settings();
  patient.source_timeout = 3.0;
  GuardedRobot robot(patient);
  robot.drives(Scene(), {0.2, 0.0, 0.0});
  robot.pass(0.1);
  EXPECT_NEAR(robot.control.until_silent(robot.now.steady), patient.command_timeout - 0.1, 1e-9);
  robot.pass(0.5);
  EXPECT_GT(robot.control.until_silent(robot.now.steady), 1.0) << "of the camera";
}

/// Without looking at anything, as for an exception.
TEST(GuardControl, WhoIsToStandStandsAndSaysWhy) {
  GuardedRobot robot;
  robot.drives(Scene(), {0.2, 0.0, 0.0});
  const Guarded& answer = robot.control.stand(robot.now, {Cause::Unreadable, "for a test"});
  EXPECT_EQ(answer.given.linear, (std::array<double, 3>{}));
  EXPECT_EQ(answer.cause, Cause::Unreadable);
  EXPECT_EQ(answer.reason, "for a test");
  EXPECT_TRUE(answer.stuck);
  EXPECT_EQ(robot.wants({0.2, 0.0, 0.0}).factor, 1.0) << "the next answer is its own";
}

TEST(GuardControl, AnAbsurdCommandIsZeroWithACause) {
  GuardedRobot robot;
  robot.see(Scene());
  for (const double odd : {std::nan(""), static_cast<double>(inf), static_cast<double>(-inf), 1e3}) {
    for (std::size_t i = 0; i < 6; ++i) {
      Command command;
      (i < 3 ? command.linear[i] : command.angular[i - 3]) = odd;
      const Guarded& answer = robot.is_told(command);
      EXPECT_EQ(answer.cause, Cause::BadCommand) << i << " " << odd;
      EXPECT_TRUE(equal_bits(answer.given, {}));
    }
  }
  EXPECT_EQ(robot.drives(Scene(), {0.3, 0.0, 0.0}).factor, 1.0);
}

TEST(GuardControl, AFasterCommandThanTheRobotMayIsScaled) {
  GuardedRobot robot;
  const Guarded& answer = robot.drives(Scene(), {1.4, 0.0, 1.0});
  EXPECT_NEAR(answer.given.linear[0], 0.7, 1e-12);
  EXPECT_NEAR(answer.given.angular[2], 0.5, 1e-12);
}

TEST(GuardControl, WhatABaseWouldNotObeyIsZeroAndStuck) {
  Settings settings = guard_settings();
  settings.min_speed = 0.5, settings.escape_speed = 0.5, settings.unseen_speed = 0.5, settings.override_speed = 0.5;
  GuardedRobot robot(settings);
  const Guarded& answer = robot.drives(Scene({wall_before(0.4)}), {0.6, 0.0, 0.0});
  EXPECT_EQ(answer.factor, 0.0);
  EXPECT_TRUE(answer.stuck);
  EXPECT_EQ(robot.drives(Scene(), {0.05, 0.0, 0.0}).factor, 1.0) << "what is safe passes, however slow";
}

TEST(GuardControl, TellsSinceWhenItIsStuck) {
  GuardedRobot robot;
  robot.drives(Scene(), {0.2, 0.0, 0.0});
  robot.pass(0.6);
  const double since = robot.now.steady;
  EXPECT_EQ(robot.wants({0.2, 0.0, 0.0}).stuck_since, since);
  robot.pass(0.3);
  EXPECT_EQ(robot.wants({0.2, 0.0, 0.0}).stuck_since, since);
  EXPECT_FALSE(robot.wants({0.0, 0.0, 0.0}).stuck);
}

TEST(GuardControl, OfWhatStandsBeforeItOnlyTheWayThereIsClosed) {
  Settings settings = guard_settings();
  settings.margin = 0.2;  // wider than the camera is blind
  GuardedRobot robot(settings);
  const Scene scene({post(0.43f, 0.0f)});
  const Guarded& answer = robot.drives(scene, {0.2, 0.0, 0.0});
  EXPECT_EQ(answer.factor, 0.0) << answer.reason;
  EXPECT_EQ(answer.open & forward, 0);
  EXPECT_EQ(answer.open & backward, backward);
  EXPECT_EQ(answer.open & turning_left, turning_left);
  EXPECT_GT(robot.drives(scene, {-0.1, 0.0, 0.0}).factor, 0.9);
}

TEST(GuardControl, ADoubtFromOutsideStopsItUntilThereIsNone) {
  GuardedRobot robot;
  ASSERT_EQ(robot.drives(Scene(), {0.2, 0.0, 0.0}).factor, 1.0);
  robot.control.note_outside(Doubt{Cause::TwoCommanders, "another"});
  EXPECT_EQ(robot.wants({0.2, 0.0, 0.0}).cause, Cause::TwoCommanders);
  robot.control.note_outside(std::nullopt);
  EXPECT_EQ(robot.wants({0.2, 0.0, 0.0}).factor, 1.0);
}

TEST(GuardControl, OdometryTellsHowFarTheCloudIsBehind) {
  GuardedRobot by_odometry, without;
  double given[2];
  for (GuardedRobot* robot : {&by_odometry, &without}) {
    robot->drives(Scene({wall_before(0.6)}), {0.3, 0.0, 0.0});
    for (int i = 0; i <= 20; ++i) {
      if (robot == &by_odometry) robot->control.note_odometry(robot->now.ros, {{0.0, 0.0}, 0.0}, {0.0, 0.0, 0.0});
      robot->pass(0.01);
    }
    given[robot == &without] = robot->wants({0.6, 0.0, 0.0}).factor;
  }
  EXPECT_GT(given[0], given[1]) << "without odometry it may have come nearer";
}

TEST(GuardControl, UnfitSettingsAreRefusedAndTheOldOnesKept) {
  GuardedRobot robot;
  Settings settings = guard_settings();
  settings.radius = -1.0;
  EXPECT_THROW(robot.control.adopt(settings), std::invalid_argument);
  EXPECT_EQ(robot.drives(Scene(), {0.2, 0.0, 0.0}).factor, 1.0);
  settings.radius = 0.3;
  robot.control.adopt(settings);
  EXPECT_EQ(robot.wants({0.2, 0.0, 0.0}).factor, 0.0) << "nothing has been seen by these yet";
  EXPECT_EQ(robot.drives(Scene(), {0.2, 0.0, 0.0}).factor, 1.0);
}

}  // namespace
}  // namespace safety_control_cloud
