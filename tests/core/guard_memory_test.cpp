// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/guard_memory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "guard/robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

const Twist2 right{0.0, -0.5, 0.0}, left{0.0, 0.5, 0.0};

TEST(GuardMemory, OneStampOfOdometryFarAheadIsNotWaitedFor) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.control.note_odometry(robot.now.ros + 1000.0, robot.pose, {});
  robot.pass(0.05);
  EXPECT_EQ(robot.wants(left).cause, Cause::NoOdometry);
  EXPECT_EQ(robot.asked(left).factor, 1.0) << robot.wants(left).reason;
}

TEST(GuardMemory, OdometryWhoseClockIsSetAheadIsNotWaitedForEither) {
  for (const double ahead : {0.5, 2.0, 60.0, 3600.0}) {
    RobotWithOdometry robot;
    robot.passes(0.5, with_post);
    robot.turns(quarter, robot.hall);
    robot.odometry_ahead = ahead;
    EXPECT_EQ(robot.asked(left).factor, 1.0) << ahead << ": " << robot.wants(left).reason;
  }
}

/// A relay says some things twice, a driver of two threads some in another order.
TEST(GuardMemory, OdometryThatComesTwiceOrALittleLateForgetsNothing) {
  for (const double late : {0.0, 0.003, 0.02, 0.2}) {
    RobotWithOdometry robot;
    robot.passes(0.5, with_post);
    robot.turns(quarter, robot.hall);
    robot.passes(0.5, robot.hall);
    robot.control.note_odometry(robot.now.ros - late, robot.pose, robot.twist);
    EXPECT_LT(robot.asked({0.0, -0.7, 0.0}).factor, 0.95) << late << ": " << robot.wants({}).reason;
  }
}

TEST(GuardMemory, AfterAJumpOfOdometryItStandsUntilEachSensorHasLooked) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.pose.place.x += 3.0;
  robot.pass(0.05);
  robot.control.note_odometry(robot.now.ros, robot.pose, {});
  const Guarded& answer = robot.wants(left);
  EXPECT_EQ(answer.cause, Cause::NoOdometry) << answer.reason;
  EXPECT_EQ(answer.factor, 0.0);
  robot.passes(0.1, robot.hall);
  EXPECT_EQ(robot.wants(left).factor, 1.0) << robot.wants(left).reason;
}

/// As one does that is corrected by a map, or whose driver starts anew while the robot stands.
TEST(GuardMemory, WhatIsKeptGoesOnAsTheBaseIsToldWhereOdometryJumpsOrPauses) {
  for (const double pause : {0.05, 2.0}) {
    RobotWithOdometry robot;
    robot.passes(0.5, with_post);
    robot.turns(quarter, robot.hall);
    robot.has_odometry = false;
    robot.passes(pause, robot.hall);
    robot.pose = {{3.0, -2.0}, 2.0};
    robot.has_odometry = true;
    const auto factor = [&](const Twist2& twist) {
      robot.passes(2.5, robot.hall);  // until whatever it was told before is over
      return robot.asked(twist).factor;
    };
    EXPECT_LT(factor({0.0, -0.7, 0.0}), 1.0) << robot.wants({}).reason;
    EXPECT_EQ(factor({0.0, 0.7, 0.0}), 1.0) << robot.wants({}).reason;
    robot.turns(quarter, robot.hall);
    EXPECT_LT(factor({-0.7, 0.0, 0.0}), 1.0) << robot.wants({}).reason;
    EXPECT_EQ(factor({0.0, -0.7, 0.0}), 1.0) << robot.wants({}).reason;
  }
}

/// A shelf at the height of its head, which is above the picture from 0.45 m on.
TEST(GuardMemory, WhatThePictureAheadDoesNotShowCountsWhileOdometryHasNotSpokenAgain) {
  Settings settings = remembering();
  settings.near_loss.distance = 0.0;
  RobotWithOdometry robot(settings);
  const auto shelf_at = [](float z) { return Scene({{z, -0.3f, 0.3f, -0.25f, -0.2f}}); };
  for (float z = 0.9f; z > 0.45f; z -= 0.05f, robot.pose.place.x += 0.05) {
    robot.twist = {1.0, 0.0, 0.0};
    robot.passes(0.05, shelf_at(z));
  }
  robot.twist = {};
  ASSERT_LT(robot.asked({0.5, 0.0, 0.0}).factor, 0.9) << robot.wants({}).reason;
  for (int i = 0; i < 30; ++i) {
    robot.pose.place.y += i % 3 == 0 ? 1.0 : 0.0;  // never for 0.2 s without a jump
    robot.passes(0.05, robot.hall);
    EXPECT_LT(robot.wants({0.5, 0.0, 0.0}).factor, 0.9) << i << ": " << robot.wants({}).reason;
    robot.wants({});
  }
}

/// Two publish it in turn, and each cloud takes as long to come as a break.
TEST(GuardMemory, WhoHearsOdometryThatNeverGoesOnDoesNotWaitForItForEver) {
  RobotWithOdometry robot;
  robot.stamp_behind = 0.05;
  robot.passes(0.5, with_post);
  robot.has_odometry = false;
  for (int i = 0; i < 100; ++i) {
    robot.control.note_odometry(robot.now.ros, {{i % 2 == 0 ? 0.0 : 5.0, 0.0}, 0.0}, {});
    robot.passes(0.05, robot.hall);
  }
  EXPECT_EQ(robot.wants({-0.1, 0.0, 0.0}).cause, Cause::Seen) << robot.wants({}).reason;
}

/// It cannot look until the robot backs off.
TEST(GuardMemory, ABlindCameraIsNotWaitedForAfterAPauseOfOdometry) {
  RobotWithOdometry robot;
  Scene blind;
  blind.blank_farther_than(0.0f);
  robot.passes(0.5, Scene({wall_before(0.25)}));
  robot.passes(0.5, blind);
  ASSERT_GT(robot.wants({-0.1, 0.0, 0.0}).factor, 0.0) << robot.wants({}).reason;
  robot.has_odometry = false;
  robot.passes(0.45, blind);
  robot.has_odometry = true;
  robot.passes(0.5, blind);
  EXPECT_GT(robot.wants({-0.1, 0.0, 0.0}).factor, 0.0) << robot.wants({}).reason;
  EXPECT_EQ(robot.wants({0.1, 0.0, 0.0}).factor, 0.0);
}

/// One looks seldom, and breaks come oftener.
TEST(GuardMemory, NobodyWaitsLongerForASensorThanWhatWasToBePlacedIsRemembered) {
  Settings settings = remembering();
  settings.memory_time = 2.0;
  settings.sensors = {{"front", InputKind::Cloud, "front", true, {}},
                      {"rear", InputKind::Cloud, "rear", true, {{"source_timeout", 10.0}}}};
  RobotWithOdometry robot(settings);
  robot.see(robot.hall.view(), xtion(), 1);
  robot.passes(0.5, with_post);
  robot.pose.place.x += 5.0;
  robot.passes(1.0, robot.hall);
  ASSERT_EQ(robot.wants({-0.1, 0.0, 0.0}).cause, Cause::NoOdometry);
  robot.passes(1.5, robot.hall);
  EXPECT_EQ(robot.wants({-0.1, 0.0, 0.0}).cause, Cause::Seen) << robot.wants({}).reason;
}

/// What it was told until the next look counts.
TEST(GuardMemory, WhoDrivesWhileOdometryJumpsHasGoneOn) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.twist = {0.4, 0.0, 0.0};
  const auto drives = [&](int looks) {
    for (int i = 0; i < looks; ++i) {
      robot.pass(0.05);
      robot.pose = beyond(robot.pose, way_of(robot.twist, 0.05));
      robot.control.note_odometry(robot.now.ros, robot.pose, robot.twist);
      robot.see(robot.hall);
      robot.wants(robot.twist);
    }
  };
  drives(8);
  robot.pose = {{-5.0, 1.0}, -1.0};
  drives(8);
  robot.twist = {};
  const Guarded& answer = robot.asked({0.0, -0.7, 0.0});
  ASSERT_TRUE(answer.point) << answer.reason;
  EXPECT_NEAR(answer.point->x, -16 * 0.05 * 0.4, 0.1) << answer.reason;
}

/// Who never had any hears nothing of it.
TEST(GuardMemory, OdometryThatIsNotBelievedIsTold) {
  RobotWithOdometry robot, without;
  without.has_odometry = false;
  robot.passes(0.5, robot.hall), without.passes(0.5, without.hall);
  EXPECT_TRUE(robot.wants({}).doubts.empty() && without.wants({}).doubts.empty());
  robot.has_odometry = false;
  robot.passes(0.5, robot.hall);
  const auto doubts = robot.wants({}).doubts;
  ASSERT_EQ(doubts.size(), std::size_t{1});
  EXPECT_NE(doubts[0].find("odometry: its latest stamp is 0.5"), std::string::npos) << doubts[0];
  EXPECT_NE(doubts[0].find(" s old"), std::string::npos) << doubts[0];
  robot.control.note_odometry(robot.now.ros + 0.4, robot.pose, {});
  EXPECT_EQ(robot.wants({}).doubts, std::vector<std::string>{"odometry: its latest stamp is 0.400 s ahead"});
}

TEST(GuardMemory, WithoutOdometryThatWasThereItStandsUntilTheirTimeEnds) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.has_odometry = false;
  EXPECT_EQ(robot.asked(left).cause, Cause::NoOdometry);
  robot.passes(29.0, robot.hall);
  EXPECT_EQ(robot.asked(left).factor, 1.0) << robot.wants(left).reason;
}

TEST(GuardMemory, WhoNeverHadOdometryDrivesByWhatHeSees) {
  RobotWithOdometry robot;
  robot.has_odometry = false;
  robot.passes(0.5, with_post);
  EXPECT_EQ(robot.asked(left).factor, 1.0);
}

/// A base that was told nothing may have stood soon, or have driven on all the while.
TEST(GuardMemory, WhoDidNotListenWhileTheRobotDroveStandsIfNothingIsPlacedByOdometry) {
  for (const bool has_odometry : {false, true}) {
    RobotWithOdometry robot;
    robot.has_odometry = has_odometry;
    robot.passes(0.5, with_post);
    const auto is_deaf = [&](double seconds) {
      robot.wants({0.2, 0.0, 0.0});
      robot.pass(seconds);
      robot.control.note_deafness(seconds, robot.now);
      robot.passes(0.3, with_post);
      return robot.wants({-0.2, 0.0, 0.0}).cause == Cause::NoOdometry;
    };
    EXPECT_FALSE(is_deaf(0.6)) << "0.12 m";
    EXPECT_EQ(is_deaf(4.0), !has_odometry);
    RobotWithOdometry next;
    next.now = robot.now;
    EXPECT_TRUE(next.control.recall(robot.control.remembered()));
    next.passes(0.3, next.hall);
    EXPECT_EQ(next.wants({-0.2, 0.0, 0.0}).cause == Cause::NoOdometry, !has_odometry) << "killed meanwhile";
    robot.passes(29.0, robot.hall);
    EXPECT_EQ(robot.wants({-0.2, 0.0, 0.0}).cause == Cause::NoOdometry, !has_odometry);
    robot.passes(1.5, robot.hall);
    EXPECT_NE(robot.wants({-0.2, 0.0, 0.0}).cause, Cause::NoOdometry) << "after memory_time";
    robot.passes(0.5, with_post);
    is_deaf(4.0);
    robot.control.forget_losses();
    EXPECT_NE(robot.wants({-0.2, 0.0, 0.0}).cause, Cause::NoOdometry) << "somebody has looked";
  }
}

TEST(GuardMemory, ResetForgets) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.control.forget_losses();
  EXPECT_EQ(robot.asked({0.0, -0.7, 0.0}).factor, 1.0);
}

/// Who drives off with the first cloud, before odometry has gone on for long enough to be asked.
TEST(GuardMemory, WhatWasSeenBeforeOdometryIsAskedIsPlacedByItToo) {
  const double distance = 0.813, rate = 1.5;
  const auto turned = [&](double first, bool from_the_start) {
    RobotWithOdometry robot;
    const auto seen = [&] {
      const double heading = robot.pose.heading;
      return Scene({post(static_cast<float>(distance * std::cos(heading) + 0.087),
                         static_cast<float>(distance * std::sin(heading)))});
    };
    if (!from_the_start) robot.passes(1.0, seen());
    robot.twist = {0.0, 0.0, rate};
    while (robot.pose.heading < first) {
      robot.pass(0.05);
      robot.pose.heading += 0.05 * rate;
      robot.control.note_odometry(robot.now.ros, robot.pose, robot.twist);
      robot.see(seen());
      robot.wants(robot.twist);
    }
    robot.turns(quarter - robot.pose.heading, robot.hall);
    return robot.asked({0.0, -0.7, 0.0});
  };
  const Guarded known = turned(0.3, false), reckoned = turned(0.3, true);
  for (const Guarded* one : {&known, &reckoned}) {
    ASSERT_TRUE(one->point) << one->reason;
    EXPECT_EQ(one->sensor, "memory");
    EXPECT_NEAR(one->point->x, 0.0, 0.05) << one->reason;
    EXPECT_NEAR(one->point->y, -distance, 0.05) << one->reason;
  }
  EXPECT_GT(known.factor, 0.0);
  EXPECT_NEAR(reckoned.factor, known.factor, 0.02);
}

/// A driver may tell of its axle, or of a frame that looks backward, and TF where base_frame is on that.
TEST(GuardMemory, OdometryOfAPartIsThatOfTheBase) {
  for (const Pose2& base : {Pose2{{0.4, 0.0}, 0.0}, Pose2{{-0.1, 0.2}, 2.0 * quarter}}) {
    RobotWithOdometry robot, other;
    const Pose2 part = between(base, Pose2{});  // as the base has it
    for (int i = 0; i < 80; ++i) {
      const Twist2 twist{0.0, 0.0, i < 20 ? 0.0 : quarter / 3.0};
      robot.pose = beyond(robot.pose, way_of(twist, 0.05));
      for (RobotWithOdometry* one : {&robot, &other}) one->pass(0.05);
      robot.control.note_odometry(robot.now.ros, robot.pose, twist);
      other.control.note_odometry(other.now.ros, beyond(robot.pose, part), twist_of_part(twist, part), base);
      for (RobotWithOdometry* one : {&robot, &other}) {
        one->see(i < 20 ? with_post : one->hall);
        one->wants({});
      }
    }
    for (const Twist2& wish : {Twist2{0.0, -0.6, 0.0}, Twist2{-0.6, 0.0, 0.0}, Twist2{0.0, 0.0, -1.0}}) {
      const Guarded answer = robot.wants(wish), same = other.wants(wish);
      EXPECT_NEAR(same.factor, answer.factor, 1e-6) << base.place.x;
      EXPECT_EQ(same.cause, Cause::Seen);
    }
    EXPECT_LT(robot.wants({0.0, -0.6, 0.0}).factor, 1.0) << "what it has turned away from";
  }
}

}  // namespace
}  // namespace safety_control_cloud
