// SPDX-License-Identifier: BSD-3-Clause
// Whose word it is that an edge is touched: two who speak for a switch, one that is no more, another process.
#include <gtest/gtest.h>

#include <string>

#include "../../../safety_control_cloud/core/guard/closed_edges.hpp"
#include "robot_with_switches.hpp"

namespace safety_control_cloud {
namespace {

using Robot = RobotWithSwitches;

/// That what somebody else touches is released.
void says_in_vain(const std::string& who, Robot& robot) {
  robot.says(kobuki, Edge::FrontLeft, false, who);
  EXPECT_EQ(robot.goes_on(2.0, forward).cause, Cause::Bumper);
}

/// It may be touched still, or have been freed meanwhile.
TEST(WhoTouched, WhatADriverSaidThatIsNoMoreHoldsUntilItsSuccessorSpeaksOrReset) {
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

TEST(WhoTouched, WhatItsSuccessorSaysIsItsOwn) {
  Robot robot;
  robot.says(kobuki, Edge::Front, true);
  robot.live(kobuki, {});
  robot.says(kobuki, Edge::Front, true);
  robot.control.forget_losses();
  EXPECT_EQ(robot.goes_on(1.0, forward).cause, Cause::Bumper);
}

TEST(WhoTouched, OfTwoWhoSpeakForItTheOneDoesNotReleaseWhatTheOtherTouches) {
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
TEST(WhoTouched, WhatOneOfTwoLeftHoldsUntilItIsBackOrAnotherHasBegunOrReset) {
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
TEST(WhoTouched, WhoBeganToSpeakSinceTheyWereAskedForLives) {
  Robot robot;
  const double asked = robot.now.steady - 0.01;
  robot.says(kobuki, Edge::Front, true, "new");
  robot.control.note_switch_living(kobuki, {"old"}, asked);
  robot.control.forget_losses();
  EXPECT_EQ(robot.goes_on(1.0, forward).cause, Cause::Bumper);
  robot.says(kobuki, Edge::Front, false, "new");
  EXPECT_EQ(robot.goes_on(1.0, forward).factor, 1.0) << robot.wants(forward).reason;
}

/// The node ends and begins again while something is touched, of which a Kobuki says nothing more.
TEST(WhoTouched, ATouchOutlivesTheProcess) {
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
TEST(WhoTouched, AnotherWhoSpeaksForItDoesNotReleaseATouchThatOutlivedTheProcess) {
  for (const bool is_gone : {false, true}) {
    Robot robot, next;
    robot.says(kobuki, Edge::FrontLeft, true, "left");
    ASSERT_TRUE(next.control.recall(robot.control.remembered()));
    if (is_gone) next.live(kobuki, {"right"});
    says_in_vain("right", next);
    if (is_gone) next.live(kobuki, {"right"});
    says_in_vain("right", next);
    next.says(kobuki, Edge::FrontLeft, false, is_gone ? "its successor" : "left");
    EXPECT_EQ(next.goes_on(2.0, forward).factor, 1.0) << next.wants(forward).reason;
  }
}

/// They are asked for at the start, and speak before the answer is there.
TEST(WhoTouched, WhoSpeaksBeforeItIsFoundToHaveBeenThereDoesNotRelease) {
  Robot robot, next;
  robot.says(kobuki, Edge::FrontLeft, true, "left");
  ASSERT_TRUE(next.control.recall(robot.control.remembered()));
  const double asked = next.now.steady;
  next.goes_on(0.1, forward);
  next.says(kobuki, Edge::FrontLeft, false, "right");
  next.control.note_switch_living(kobuki, {"right"}, asked);
  says_in_vain("right", next);
}

/// All drivers are started anew, or cut off for a while; the one that touched something is not back yet, or says
/// nothing as long as nothing changes.
TEST(WhoTouched, WhoWasThereBesideItAndIsBackDoesNotRelease) {
  for (const bool is_another_process : {false, true}) {
    Robot robot, next;
    robot.says(kobuki, Edge::FrontLeft, true, "left");
    robot.says(kobuki, Edge::FrontLeft, false, "right");
    ASSERT_TRUE(next.control.recall(robot.control.remembered()));
    Robot& then = is_another_process ? next : robot;
    then.live(kobuki, {});
    says_in_vain("right", then);
    then.live(kobuki, {"left", "right"});
    says_in_vain("right", then);
    then.says(kobuki, Edge::FrontLeft, false, "left");
    EXPECT_EQ(then.goes_on(2.0, forward).factor, 1.0) << then.wants(forward).reason;
  }
}

/// As a Kobuki's does, which says nothing as long as its bumper stays pressed.
TEST(WhoTouched, WhoseDriverIsBackAndHasNotSpokenIsReleasedByNobodyElse) {
  Robot robot;
  robot.says(kobuki, Edge::FrontLeft, true, "left");
  robot.live(kobuki, {});
  robot.live(kobuki, {"left"});
  says_in_vain("next", robot);
  robot.says(kobuki, Edge::FrontLeft, false, "left");
  EXPECT_EQ(robot.goes_on(2.0, forward).factor, 1.0) << robot.wants(forward).reason;
}

TEST(WhoTouched, ATouchOfASwitchThatIsNotThereByNowClosesAllUntilReset) {
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

TEST(WhoTouched, WhatIsNotLegibleTouchesNothing) {
  ClosedEdges edges(with_switches().switches);
  for (const char* text : {"", "touched-3", "touched-3 1 bumper", "touched-3 1 bumper front",
                           "touched-3 1 bumper front driver", "touched-3 1 bumper front driver 0",
                           "touched-3 1 bumper top driver 0 end", "touched-3 2 bumper front driver 0 end",
                           "touched-3 1 other front driver 0 end", "touched-3 1 bumper front driver end",
                           "touched-3 1 bumper front driver 1 other driver end", "touched-2 1 bumper front driver end"})
    EXPECT_FALSE(edges.recall(text)) << text;
  EXPECT_TRUE(edges.known_at(100.0, 0.5).empty());
  EXPECT_TRUE(edges.recall("touched-3 1 bumper front driver 1 bumper driver end"));
  EXPECT_EQ(edges.known_at(100.0, 0.5).size(), std::size_t{1});
}

}  // namespace
}  // namespace safety_control_cloud
