// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/stamped.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "guarded_robot.hpp"

namespace safety_control_cloud {
namespace {

constexpr StampLimits limits{0.3, 1.0};
constexpr double now = 1000.0, odd = std::numeric_limits<double>::quiet_NaN();

TEST(Stamped, WhatIsOfNowMayComeAndWhatIsOldAheadOrUnknownMayNot) {
  for (const double stamp : {now, now - 0.299, now + 0.999})
    EXPECT_FALSE(refusal_of_stamp(stamp, now, limits)) << stamp;
  for (const double stamp : {now - 0.301, 1.0, now + 1.001, 4e9, 0.0, -1.0, odd})
    EXPECT_TRUE(refusal_of_stamp(stamp, now, limits)) << stamp;
}

TEST(Stamped, AReasonSaysWhatIsWrong) {
  EXPECT_NE(refusal_of_stamp(0.0, now, limits)->find("stamp is 0"), std::string::npos);
  EXPECT_NE(refusal_of_stamp(now - 2.0, now, limits)->find("2.000 s old"), std::string::npos);
  EXPECT_NE(refusal_of_stamp(now + 2.0, now, limits)->find("2.000 s ahead"), std::string::npos);
}

TEST(Stamped, WithoutAToleranceAnyStampAheadWillDoButNoOldOne) {
  EXPECT_FALSE(refusal_of_stamp(now + 500.0, now, {0.3, 0.0}));
  EXPECT_TRUE(refusal_of_stamp(now - 0.4, now, {0.3, 0.0}));
}

TEST(Stamped, WhileRosTimeStandsAtZeroNothingMay) {
  EXPECT_TRUE(refusal_of_stamp(0.0, 0.0, limits));
  EXPECT_TRUE(refusal_of_stamp(now, 0.0, limits));
}

struct StampedRobot : GuardedRobot {
  explicit StampedRobot(const Settings& settings = guard_settings()) : GuardedRobot(settings) { see(Scene()); }
  const Guarded& is_told(double stamp, double speed = 0.3) {
    Command command;
    command.linear[0] = speed;
    control.want(command, this->now, stamp);
    return control.answer(this->now);
  }
};

TEST(Stamped, ABurstAfterAGapDrivesNothingOld) {
  StampedRobot robot;
  ASSERT_EQ(robot.is_told(robot.now.ros - 0.1).factor, 1.0);
  robot.pass(2.0);
  robot.see(Scene());
  for (double age = 1.9; age > 0.31; age -= 0.02) {
    const Guarded& answer = robot.is_told(robot.now.ros - age);
    ASSERT_EQ(answer.cause, Cause::BadCommand) << age;
    ASSERT_EQ(answer.given.linear[0], 0.0);
    ASSERT_FALSE(answer.stuck);
  }
  EXPECT_EQ(robot.is_told(robot.now.ros - 0.29).factor, 1.0);
}

TEST(Stamped, AnOldCommandEndsTheOneBefore) {
  StampedRobot robot;
  ASSERT_EQ(robot.is_told(robot.now.ros).factor, 1.0);
  EXPECT_EQ(robot.is_told(robot.now.ros - 1.0).given.linear[0], 0.0);
  EXPECT_EQ(robot.control.answer(robot.now).cause, Cause::BadCommand);
  robot.pass(0.51);
  robot.see(Scene());
  EXPECT_EQ(robot.control.answer(robot.now).cause, Cause::NoCommand);
}

TEST(Stamped, WhatWasSaidBeforeAStopDoesNotEndIt) {
  StampedRobot robot;
  const double start = robot.now.ros;
  ASSERT_EQ(robot.is_told(start).factor, 1.0);
  EXPECT_EQ(robot.is_told(start - 0.1, 0.0).given.linear[0], 0.0) << "a stop counts, however late it comes";
  EXPECT_EQ(robot.is_told(start).given.linear[0], 0.3) << "which was said after it";
  robot.pass(0.1);
  robot.see(Scene());
  ASSERT_EQ(robot.is_told(start + 0.1, 0.0).given.linear[0], 0.0);
  EXPECT_EQ(robot.is_told(start + 0.05).given.linear[0], 0.0);
  EXPECT_EQ(robot.is_told(start + 0.1).given.linear[0], 0.3);
  ASSERT_EQ(robot.is_told(start + 1.0, 0.0).given.linear[0], 0.0) << "its clock is ahead";
  robot.pass(0.6);
  robot.see(Scene());
  EXPECT_EQ(robot.is_told(start + 0.65).given.linear[0], 0.3) << "longer ago than any command counts";
}

TEST(Stamped, ARefusedStopHoldsAgainstNothingAndARefusedCommandEndsNoStop) {
  StampedRobot robot;
  const double start = robot.now.ros;
  ASSERT_EQ(robot.is_told(start + 2.0, 0.0).cause, Cause::BadCommand);
  EXPECT_EQ(robot.is_told(start).given.linear[0], 0.3);
  ASSERT_EQ(robot.is_told(start + 0.1, 0.0).given.linear[0], 0.0);
  EXPECT_EQ(robot.is_told(0.0).cause, Cause::BadCommand) << "and says so";
  EXPECT_EQ(robot.is_told(start + 0.05).given.linear[0], 0.0);
}

TEST(Stamped, AStopHoldsAsLongAsCommandsOfBeforeItAreYoungEnough) {
  Settings settings = guard_settings();
  settings.command_max_age = 2.0;
  StampedRobot robot(settings);
  const double start = robot.now.ros;
  ASSERT_EQ(robot.is_told(start).given.linear[0], 0.3);
  ASSERT_EQ(robot.is_told(start + 0.1, 0.0).given.linear[0], 0.0);
  robot.pass(0.8);
  robot.see(Scene());
  EXPECT_EQ(robot.is_told(start).given.linear[0], 0.0);
  EXPECT_EQ(robot.is_told(start + 0.2).given.linear[0], 0.3);
}

TEST(Stamped, AClockThatIsSetBackMakesStampsOfBeforeOnesAhead) {
  StampedRobot robot;
  const double stamp = robot.now.ros;
  robot.now.ros -= 100.0;
  EXPECT_NE(robot.is_told(stamp).factor, 1.0);
}

}  // namespace
}  // namespace safety_control_cloud
