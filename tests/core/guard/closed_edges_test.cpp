// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/closed_edges.hpp"

#include <gtest/gtest.h>

#include <string>

#include "robot_with_switches.hpp"

namespace safety_control_cloud {
namespace {

using Robot = RobotWithSwitches;

TEST(ClosedEdges, NoneIsClosedUntilSomethingIsTouched) {
  Robot robot;
  EXPECT_EQ(robot.wants(forward).factor, 1.0);
  robot.says(bumper, Edge::Front, false);
  EXPECT_EQ(robot.wants(forward).factor, 1.0);
}

TEST(ClosedEdges, ATouchStopsAtOnceAndNamesItself) {
  Robot robot;
  robot.says(bumper, Edge::Front, true);
  const Guarded& answer = robot.wants(forward);
  EXPECT_EQ(answer.factor, 0.0);
  EXPECT_EQ(answer.cause, Cause::Bumper);
  EXPECT_EQ(answer.sensor, "bumper");
  EXPECT_NE(answer.reason.find("front"), std::string::npos) << answer.reason;
  EXPECT_TRUE(answer.stuck);
  EXPECT_EQ(answer.open, 2) << "backward alone";
  robot.says(cliff, Edge::FrontLeft, true);
  robot.says(bumper, Edge::Front, false);
  EXPECT_EQ(robot.goes_on(1.0, forward).cause, Cause::Cliff);
}

TEST(ClosedEdges, AwayFromItIsOpenAtEscapeSpeedAndNothingElse) {
  for (const Edge edge : {Edge::Front, Edge::FrontLeft, Edge::FrontRight}) {
    Robot robot;
    robot.says(kobuki, edge, true);
    EXPECT_EQ(robot.goes_on(1.0, turning).factor, 0.0) << name_of(edge);
    const Guarded& back = robot.goes_on(1.0, backward);
    EXPECT_NEAR(back.given.linear[0], -robot.control.settings().escape_speed, 1e-12) << name_of(edge);
    EXPECT_EQ(robot.goes_on(0.5, {-0.3, 0.0, 0.5}).factor, 0.0) << "its front would swing";
  }
  for (const Edge edge : {Edge::Rear, Edge::RearLeft, Edge::RearRight}) {
    Robot robot;
    robot.says(kobuki, edge, true);
    EXPECT_EQ(robot.goes_on(1.0, backward).factor, 0.0) << name_of(edge);
    EXPECT_NEAR(robot.goes_on(1.0, forward).given.linear[0], robot.control.settings().escape_speed, 1e-12);
  }
}

TEST(ClosedEdges, AwayFromItIsSlowThoughASensorLooksThere) {
  Robot robot;
  robot.says(kobuki, Edge::Rear, true);
  EXPECT_EQ(robot.wants(forward).reason.substr(0, 13), "something tou") << "and the camera sees a free hall";
}

TEST(ClosedEdges, FromASideARobotMovesSidewaysAlone) {
  Robot robot;
  robot.says(kobuki, Edge::Left, true);
  EXPECT_EQ(robot.goes_on(1.0, forward).factor, 0.0);
  EXPECT_EQ(robot.goes_on(1.0, {0.0, 0.3, 0.0}).factor, 0.0);
  EXPECT_GT(robot.goes_on(1.0, {0.0, -0.3, 0.0}).factor, 0.0);
}

TEST(ClosedEdges, BetweenTwoThatAreTouchedThereIsNoWay) {
  Robot robot;
  robot.says(kobuki, Edge::Front, true);
  robot.says(kobuki, Edge::Rear, true);
  for (const Twist2& twist : {forward, backward, turning, Twist2{0.0, 0.3, 0.0}})
    EXPECT_EQ(robot.goes_on(0.5, twist).factor, 0.0);
}

TEST(ClosedEdges, ItIsClosedUntilItHasBeenReleasedAndHeld) {
  Robot robot;
  robot.says(bumper, Edge::Front, true);
  EXPECT_EQ(robot.goes_on(60.0, forward).factor, 0.0) << "however long nothing more is said";
  robot.says(bumper, Edge::Front, false);
  EXPECT_EQ(robot.goes_on(0.4, forward).cause, Cause::Bumper);
  robot.says(bumper, Edge::Front, true);
  robot.says(bumper, Edge::Front, false);
  EXPECT_EQ(robot.goes_on(0.4, forward).factor, 0.0) << "it rattles";
  robot.says(bumper, Edge::Front, false);  // said again, it is no other release
  EXPECT_EQ(robot.goes_on(0.15, forward).cause, Cause::Seen);
  EXPECT_EQ(robot.goes_on(0.5, forward).factor, 1.0);
}

TEST(ClosedEdges, OneIsNotReleasedByAnother) {
  Robot robot;
  robot.says(kobuki, Edge::FrontLeft, true);
  robot.says(kobuki, Edge::Front, true);
  robot.says(kobuki, Edge::Front, false);
  robot.says(bumper, Edge::FrontLeft, false);
  EXPECT_EQ(robot.goes_on(2.0, forward).cause, Cause::Bumper);
}

TEST(ClosedEdges, OfOneThatShouldSpeakSilenceIsADoubt) {
  Settings settings = with_switches();
  settings.switches[cliff].timeout = 0.3;
  Robot robot(settings);
  EXPECT_EQ(robot.wants(backward).cause, Cause::Silent) << "it has never spoken";
  EXPECT_EQ(robot.wants(backward).sensor, "cliff");
  robot.says(cliff, Edge::FrontLeft, false);
  EXPECT_EQ(robot.goes_on(0.25, forward).cause, Cause::Seen);
  EXPECT_EQ(robot.goes_on(0.1, forward).cause, Cause::Silent);
  EXPECT_EQ(robot.wants(forward).factor, 0.0);
  robot.says(cliff, Edge::FrontLeft, false);
  EXPECT_EQ(robot.goes_on(0.2, forward).factor, 1.0);
}

TEST(ClosedEdges, WhatSpeaksAgainstASwitchStopsEveryMotion) {
  Robot robot;
  robot.control.note_about_switch(bumper, Doubt{Cause::Unreadable, "of another type"});
  EXPECT_EQ(robot.goes_on(0.5, backward).cause, Cause::Unreadable);
  EXPECT_EQ(robot.wants(forward).factor, 0.0);
  robot.control.note_about_switch(bumper, std::nullopt);
  EXPECT_EQ(robot.goes_on(0.5, forward).factor, 1.0);
}

TEST(ClosedEdges, AnOverrideOutlivesATouchOnlyIfThatWasAsked) {
  for (const bool even_in_doubt : {false, true}) {
    Settings settings = with_switches();
    settings.override_max = 30.0;
    Robot robot(settings);
    ASSERT_TRUE(robot.control.ask_override({10.0, 0.1, even_in_doubt}, robot.now).granted);
    robot.says(bumper, Edge::Front, true);
    EXPECT_EQ(robot.wants(forward).factor > 0.0, even_in_doubt);
    EXPECT_EQ(robot.control.ask_override({10.0, 0.1, false}, robot.now).granted, false);
  }
}

TEST(ClosedEdges, StayClosedThroughAChangeOfOtherSettingsAndAReset) {
  Robot robot;
  robot.says(bumper, Edge::Front, true);
  Settings changed = with_switches();
  changed.noise = 0.02;
  robot.control.adopt(changed);
  robot.control.forget_losses();
  EXPECT_EQ(robot.goes_on(0.5, forward).cause, Cause::Bumper);
}

TEST(ClosedEdges, AWayOutThatNobodySeesIsNoneWhereThatIsForbidden) {
  Settings settings = with_switches();
  settings.unseen_speed = 0.0;
  Robot robot(settings);
  robot.says(bumper, Edge::Front, true);
  EXPECT_EQ(robot.goes_on(0.5, backward).factor, 0.0);
}

}  // namespace
}  // namespace safety_control_cloud
