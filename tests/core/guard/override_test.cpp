// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/override.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "guarded_robot.hpp"

namespace safety_control_cloud {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Twist2 ahead{0.3, 0.0, 0.0};

Settings docking() {
  Settings settings = guard_settings();
  settings.override_max = 10.0;
  settings.override_speed = 0.4;
  return settings;
}

/// A robot that can get no nearer to a wall.
struct BeforeAWall : GuardedRobot {
  explicit BeforeAWall(const Settings& settings = docking()) : GuardedRobot(settings) { drives(wall, ahead); }

  OverrideReply ask(double seconds, double speed, bool even_in_doubt = false) {
    return control.ask_override({seconds, speed, even_in_doubt}, now);
  }
  /// Both go on, the camera and who drives.
  void go_on(double seconds) {
    pass(seconds);
    see(wall);
  }

  Scene wall{{wall_before(0.16)}};
};

TEST(Override, IsRefusedUnlessEnabled) {
  BeforeAWall robot(guard_settings());
  const OverrideReply reply = robot.ask(1.0, 0.1);
  EXPECT_FALSE(reply.granted);
  EXPECT_NE(reply.words.find("override_max"), std::string::npos);
  EXPECT_EQ(robot.wants(ahead).override_left, 0.0);
  EXPECT_EQ(robot.wants(ahead).cause, Cause::Seen);
}

TEST(Override, LetsACommandPassScaledAsAWholeToItsSpeedAndEndsByItself) {
  BeforeAWall robot;
  const double before = robot.wants(ahead).factor;
  ASSERT_LT(before * ahead.vx, 0.25);
  ASSERT_TRUE(robot.ask(1.0, 0.3).granted);
  for (int i = 0; i < 9; ++i) {
    robot.go_on(0.1);
    const Guarded& answer = robot.wants({0.6, -0.0, 0.0});
    EXPECT_NEAR(answer.given.linear[0], 0.3, 1e-12);
    EXPECT_EQ(answer.cause, Cause::Seen);
    EXPECT_NEAR(answer.override_left, 0.9 - 0.1 * i, 1e-9);
    EXPECT_NE(answer.reason.find("~override"), std::string::npos) << answer.reason;
  }
  robot.go_on(0.1001);
  const Guarded& after = robot.wants(ahead);
  EXPECT_EQ(after.override_left, 0.0);
  EXPECT_LE(after.factor, before) << "as if there had been none";
}

TEST(Override, WhatIsSlowerPassesEqualInEveryBit) {
  BeforeAWall robot;
  ASSERT_TRUE(robot.ask(1.0, 0.2).granted);
  EXPECT_EQ(robot.wants({0.1, 0.0, 0.0}).factor, 1.0);
  EXPECT_EQ(robot.wants({0.2, 0.0, 0.0}).factor, 1.0);
  const Guarded& turning = robot.wants({0.3, 0.0, 0.6});
  EXPECT_LT(turning.factor, 1.0);
  EXPECT_DOUBLE_EQ(turning.given.angular[2], 2.0 * turning.given.linear[0]) << "as a whole";
}

TEST(Override, OddWishesAreRefusedAndTheOneThatHoldsGoesOn) {
  BeforeAWall robot;
  ASSERT_TRUE(robot.ask(1.0, 0.1).granted);
  const OverrideWish odd[] = {
      {-1.0, 0.1, true}, {nan_value, 0.1, true}, {infinite, 0.1, true},  {10.1, 0.1, true},     {1.0, -0.1, true},
      {1.0, 0.0, true},  {1.0, 0.41, true},      {1.0, nan_value, true}, {1.0, infinite, true}, {-infinite, 0.1, true}};
  for (const OverrideWish& wish : odd)
    EXPECT_FALSE(robot.control.ask_override(wish, robot.now).granted) << wish.seconds << " " << wish.speed;
  EXPECT_NEAR(robot.wants(ahead).override_left, 1.0, 1e-9);
  EXPECT_NEAR(robot.wants(ahead).given.linear[0], 0.1, 1e-9);
}

TEST(Override, ASecondOneTakesThePlaceOfTheFirstAndZeroSecondsEndIt) {
  BeforeAWall robot;
  ASSERT_TRUE(robot.ask(5.0, 0.2, true).granted);
  robot.go_on(0.1);
  ASSERT_TRUE(robot.ask(0.5, 0.1).granted);
  EXPECT_NEAR(robot.wants(ahead).given.linear[0], 0.1, 1e-9);
  EXPECT_NEAR(robot.wants(ahead).override_left, 0.5, 1e-9);
  robot.control.see(Unreadable{"no field x"}, {robot.now.ros, xtion(), "camera", ""}, robot.now);
  EXPECT_EQ(robot.wants(ahead).factor, 0.0) << "the second was not asked for in doubt";
  EXPECT_TRUE(robot.ask(0.0, nan_value).granted);
  EXPECT_EQ(robot.wants(ahead).override_left, 0.0);
  EXPECT_TRUE(robot.ask(0.0, 0.1).granted) << "to end none is no mistake";
}

TEST(Override, InDoubtItIsRefusedAndStandsUnlessAskedForExplicitly) {
  BeforeAWall robot;
  const auto doubt = [&] {
    robot.control.see(Unreadable{"no field x"}, {robot.now.ros, xtion(), "camera", ""}, robot.now);
  };
  doubt();
  const OverrideReply refused = robot.ask(1.0, 0.1);
  EXPECT_FALSE(refused.granted);
  EXPECT_NE(refused.words.find("UNREADABLE"), std::string::npos) << refused.words;
  ASSERT_TRUE(robot.ask(1.0, 0.1, true).granted);
  const Guarded& answer = robot.wants(ahead);
  EXPECT_NEAR(answer.given.linear[0], 0.1, 1e-9);
  EXPECT_EQ(answer.cause, Cause::Unreadable) << "nobody takes it for sight";
  robot.go_on(0.1);
  ASSERT_TRUE(robot.ask(1.0, 0.1).granted);
  doubt();
  EXPECT_EQ(robot.wants(ahead).factor, 0.0) << "what came into doubt since";
  robot.go_on(0.1);
  EXPECT_GT(robot.wants(ahead).factor, 0.0);
}

TEST(Override, SilenceIsADoubtThoughNobodyHasAskedMeanwhile) {
  BeforeAWall robot;
  robot.pass(5.0);
  EXPECT_FALSE(robot.ask(1.0, 0.1).granted);
  GuardedRobot never_saw(docking());
  EXPECT_FALSE(never_saw.control.ask_override({1.0, 0.1, false}, never_saw.now).granted);
  ASSERT_TRUE(never_saw.control.ask_override({1.0, 0.1, true}, never_saw.now).granted);
  EXPECT_NEAR(never_saw.wants(ahead).given.linear[0], 0.1, 1e-9);
}

TEST(Override, OfACameraBlindBeforeAWallItMustBeAskedForInDoubt) {
  GuardedRobot robot(docking());
  robot.drives(Scene({wall_before(0.2)}), {0.1, 0.0, 0.0});
  const Scene too_near({wall_before(0.1)});
  ASSERT_EQ(robot.drives(too_near, {0.1, 0.0, 0.0}).cause, Cause::Blind);
  EXPECT_FALSE(robot.control.ask_override({1.0, 0.1, false}, robot.now).granted);
  EXPECT_EQ(robot.drives(too_near, {-0.1, 0.0, 0.0}).factor, 1.0) << "the guard's own way out stays";
  ASSERT_TRUE(robot.control.ask_override({1.0, 0.1, true}, robot.now).granted);
  EXPECT_NEAR(robot.wants(ahead).given.linear[0], 0.1, 1e-9);
}

TEST(Override, WhatIsNoMatterOfSightStillStops) {
  BeforeAWall robot;
  ASSERT_TRUE(robot.ask(5.0, 0.2, true).granted);
  for (const double odd : {nan_value, infinite, 1e3}) EXPECT_EQ(robot.wants({odd, 0.0, 0.0}).cause, Cause::BadCommand);
  EXPECT_EQ(robot.wants({nan_value, 0.0, 0.0}).given.linear[0], 0.0);
  robot.control.note_outside(Doubt{Cause::TwoCommanders, "another"});
  EXPECT_EQ(robot.wants(ahead).cause, Cause::TwoCommanders);
  EXPECT_EQ(robot.wants(ahead).factor, 0.0);
  robot.control.note_outside(Doubt{Cause::Stale, "from before the process went on"});
  EXPECT_GT(robot.wants(ahead).factor, 0.0);
  robot.control.note_outside(std::nullopt);
  robot.go_on(0.51);
  EXPECT_EQ(robot.control.answer(robot.now).cause, Cause::NoCommand);
  EXPECT_EQ(robot.control.answer(robot.now).factor, 0.0);
}

TEST(Override, HoldsByTheSteadyClockWhateverRosTimeDoes) {
  BeforeAWall robot;
  ASSERT_TRUE(robot.ask(1.0, 0.1, true).granted);
  robot.now.ros -= 500.0;
  robot.pass(0.9);
  EXPECT_GT(robot.wants(ahead).factor, 0.0);
  robot.now.ros += 9000.0;
  robot.pass(0.1001);
  EXPECT_EQ(robot.wants(ahead).override_left, 0.0);
}

TEST(Override, SettingsThatWouldRefuseItEndIt) {
  BeforeAWall robot;
  ASSERT_TRUE(robot.ask(5.0, 0.2, true).granted);
  Settings slower = docking();
  slower.override_speed = 0.05;
  robot.control.adopt(slower);
  EXPECT_NEAR(robot.wants(ahead).given.linear[0], 0.05, 1e-9);
  robot.control.adopt(guard_settings());
  robot.control.adopt(docking());
  EXPECT_EQ(robot.wants(ahead).override_left, 0.0) << "not even when it is enabled again";
}

}  // namespace
}  // namespace safety_control_cloud
