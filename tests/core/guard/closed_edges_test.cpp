// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/closed_edges.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "guarded_robot.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::size_t bumper = 0, cliff = 1, kobuki = 2;
constexpr Twist2 forward{0.3, 0.0, 0.0}, backward{-0.3, 0.0, 0.0}, turning{0.0, 0.0, 0.5};

Settings with_switches() {
  Settings settings = guard_settings();
  settings.switches = {{"bumper", SwitchKind::Bumper, "bumper", Edge::Front, 0.0},
                       {"cliff", SwitchKind::Cliff, "cliff", Edge::FrontLeft, 0.0},
                       {"kobuki", SwitchKind::Bumper, "events", std::nullopt, 0.0}};
  return settings;
}

/// In a free hall; its camera goes on.
struct Robot : GuardedRobot {
  explicit Robot(const Settings& settings = with_switches()) : GuardedRobot(settings) { drives(hall, forward); }

  void says(std::size_t which, Edge edge, bool touched, const std::string& who = "driver") {
    control.note_switch(which, who, edge, touched, now);
  }

  /// Found out a moment after the latest word.
  void live(std::size_t which, const std::vector<std::string>& who) {
    now = {now.steady + 0.001, now.ros + 0.001};
    control.note_switch_living(which, who, now.steady);
    now = {now.steady + 0.001, now.ros + 0.001};
  }

  const Guarded& goes_on(double seconds, const Twist2& twist) {
    for (double gone = 0.0; gone < seconds - 1e-9; gone += 0.05) drives_on(hall, twist);
    return wants(twist);
  }

  Scene hall{{}};
};

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

/// It may be touched still, or have been freed meanwhile.
TEST(ClosedEdges, WhatADriverSaidThatIsNoMoreHoldsUntilItsSuccessorSpeaksOrReset) {
  for (const bool is_reset : {false, true}) {
    Robot robot;
    robot.says(kobuki, Edge::Front, true);
    robot.control.forget_losses();
    EXPECT_EQ(robot.goes_on(1.0, forward).cause, Cause::Bumper) << "somebody says so still";
    robot.live(kobuki, {});
    EXPECT_EQ(robot.goes_on(1.0, forward).cause, Cause::Bumper);
    EXPECT_NE(robot.wants(forward).hint.find("~reset"), std::string::npos) << robot.wants(forward).hint;
    is_reset ? robot.control.forget_losses() : robot.says(kobuki, Edge::Front, false);
    EXPECT_EQ(robot.goes_on(1.0, forward).factor, 1.0) << robot.wants(forward).reason;
  }
}

TEST(ClosedEdges, WhatItsSuccessorSaysIsItsOwn) {
  Robot robot;
  robot.says(kobuki, Edge::Front, true);
  robot.live(kobuki, {});
  robot.says(kobuki, Edge::Front, true);
  robot.control.forget_losses();
  EXPECT_EQ(robot.goes_on(1.0, forward).cause, Cause::Bumper);
}

TEST(ClosedEdges, OfTwoWhoSpeakForItTheOneDoesNotReleaseWhatTheOtherTouches) {
  Robot robot;
  robot.says(bumper, Edge::Front, true, "left");
  robot.says(bumper, Edge::Front, false, "right");
  EXPECT_EQ(robot.goes_on(1.0, forward).cause, Cause::Bumper);
  robot.says(bumper, Edge::Front, false, "right");
  EXPECT_EQ(robot.goes_on(1.0, forward).cause, Cause::Bumper);
  robot.says(bumper, Edge::Front, false, "left");
  EXPECT_EQ(robot.goes_on(1.0, forward).factor, 1.0) << robot.wants(forward).reason;
}

/// Another one lives, and speaks for it too.
TEST(ClosedEdges, WhatOneOfTwoLeftHoldsUntilItIsBackOrAnotherHasBegunOrReset) {
  for (const char* end : {"it is back", "another has begun", "~reset"}) {
    Robot robot;
    robot.says(kobuki, Edge::Front, true, "left");
    robot.says(kobuki, Edge::Rear, false, "right");
    robot.live(kobuki, {"left", "right"});
    robot.control.forget_losses();
    robot.says(kobuki, Edge::Front, false, "right");
    EXPECT_EQ(robot.goes_on(1.0, forward).cause, Cause::Bumper) << end;
    robot.live(kobuki, {"right"});
    robot.says(kobuki, Edge::Front, false, "right");
    EXPECT_EQ(robot.goes_on(1.0, forward).cause, Cause::Bumper) << end;
    EXPECT_NE(robot.wants(forward).hint.find("~reset"), std::string::npos) << robot.wants(forward).hint;
    if (end == std::string("~reset")) robot.control.forget_losses();
    if (end == std::string("it is back")) robot.says(kobuki, Edge::Front, false, "left");
    if (end == std::string("another has begun")) robot.says(kobuki, Edge::Front, false, "next");
    EXPECT_EQ(robot.goes_on(1.0, forward).factor, 1.0) << end << ": " << robot.wants(forward).reason;
  }
}

/// Who was asked for before it spoke is not gone for that.
TEST(ClosedEdges, WhoBeganToSpeakSinceTheyWereAskedForLives) {
  Robot robot;
  const double asked = robot.now.steady - 0.01;
  robot.says(kobuki, Edge::Front, true, "new");
  robot.control.note_switch_living(kobuki, {"old"}, asked);
  robot.control.forget_losses();
  EXPECT_EQ(robot.goes_on(1.0, forward).cause, Cause::Bumper);
  robot.says(kobuki, Edge::Front, false, "new");
  EXPECT_EQ(robot.goes_on(1.0, forward).factor, 1.0) << robot.wants(forward).reason;
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

/// The node ends and begins again while something is touched, of which a Kobuki says nothing more.
TEST(ClosedEdges, ATouchOutlivesTheProcess) {
  Robot robot, next, other;
  robot.says(kobuki, Edge::FrontLeft, true);
  robot.says(cliff, Edge::FrontLeft, true);
  robot.says(cliff, Edge::FrontLeft, false);
  const auto remembered = robot.control.remembered();
  ASSERT_TRUE(next.control.recall(remembered));
  const Guarded& answer = next.goes_on(5.0, forward);
  EXPECT_EQ(answer.factor, 0.0);
  EXPECT_EQ(answer.cause, Cause::Bumper);
  EXPECT_EQ(answer.sensor, "kobuki");
  EXPECT_FALSE(answer.hint.empty());
  EXPECT_EQ(next.control.remembered(), remembered) << "and the next one";
  next.says(kobuki, Edge::FrontLeft, false);
  EXPECT_EQ(next.goes_on(2.0, forward).factor, 1.0) << next.wants(forward).reason;
  ASSERT_TRUE(other.control.recall(remembered));
  other.control.forget_losses();
  EXPECT_EQ(other.goes_on(2.0, forward).factor, 1.0) << other.wants(forward).reason;
}

/// Who did not touch it, and speaks for it all the time, was there before too.
TEST(ClosedEdges, AnotherWhoSpeaksForItDoesNotReleaseATouchThatOutlivedTheProcess) {
  for (const bool is_gone : {false, true}) {
    Robot robot, next;
    robot.says(kobuki, Edge::FrontLeft, true, "left");
    ASSERT_TRUE(next.control.recall(robot.control.remembered()));
    if (is_gone) next.live(kobuki, {"right"});
    next.says(kobuki, Edge::FrontLeft, false, "right");
    EXPECT_EQ(next.goes_on(2.0, forward).cause, Cause::Bumper);
    if (is_gone) next.live(kobuki, {"right"});
    next.says(kobuki, Edge::FrontLeft, false, "right");
    EXPECT_EQ(next.goes_on(2.0, forward).cause, Cause::Bumper);
    next.says(kobuki, Edge::FrontLeft, false, is_gone ? "its successor" : "left");
    EXPECT_EQ(next.goes_on(2.0, forward).factor, 1.0) << next.wants(forward).reason;
  }
}

TEST(ClosedEdges, ATouchOfASwitchThatIsNotThereByNowClosesAllUntilReset) {
  Robot robot;
  robot.says(kobuki, Edge::FrontLeft, true);
  Settings without = with_switches();
  without.switches.pop_back();
  Robot next(without);
  EXPECT_FALSE(next.control.recall(robot.control.remembered()));
  EXPECT_EQ(next.goes_on(2.0, backward).factor, 0.0);
  next.control.forget_losses();
  EXPECT_EQ(next.goes_on(2.0, forward).factor, 1.0) << next.wants(forward).reason;
}

TEST(ClosedEdges, WhatIsNotLegibleTouchesNothing) {
  ClosedEdges edges(with_switches().switches);
  for (const char* text :
       {"", "touched-2", "touched-2 1 bumper", "touched-2 1 bumper front", "touched-2 1 bumper front driver",
        "touched-2 1 bumper top driver end", "touched-2 2 bumper front driver end",
        "touched-2 1 other front driver end", "touched-1 1 bumper front end"})
    EXPECT_FALSE(edges.recall(text)) << text;
  EXPECT_TRUE(edges.known_at(100.0, 0.5).empty());
  EXPECT_TRUE(edges.recall("touched-2 1 bumper front driver end"));
  EXPECT_EQ(edges.known_at(100.0, 0.5).size(), std::size_t{1});
}

}  // namespace
}  // namespace safety_control_cloud
