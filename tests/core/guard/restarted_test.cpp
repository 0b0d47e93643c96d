// SPDX-License-Identifier: BSD-3-Clause
// What became of the places that a guard kept, in the process that goes on after it was killed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "robot_with_odometry.hpp"
#include "robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

const Twist2 right{0.0, -0.7, 0.0};

/// A robot that has turned away from a post, which is on its right; and one that goes on after it was killed.
struct RestartedRobot {
  RobotWithOdometry robot, next;
  std::vector<std::string> remembered;

  explicit RestartedRobot(double seconds = 3.0, const Pose2& start = {}, int full_turns = 0,
                          double spoke_again_for = 0.0) {
    robot.pose = start;
    robot.passes(0.5, with_post);
    robot.turns(quarter + 4.0 * quarter * full_turns, robot.hall);
    robot.passes(0.5, robot.hall);
    if (spoke_again_for > 0.0) {
      robot.has_odometry = false;
      robot.passes(0.4, robot.hall);
      robot.has_odometry = true;
      robot.passes(spoke_again_for, robot.hall);
    }
    remembered = robot.control.remembered();
    next.now = robot.now;
    next.now.steady += 5000.0;  // another computer's, or another boot
    next.pass(seconds);
    next.pose = robot.pose;
    next.pose.heading = std::remainder(next.pose.heading, 4.0 * quarter);
  }

  const Guarded& asked(const Twist2& twist) {
    EXPECT_TRUE(next.control.recall(remembered));
    return next.asked(twist);
  }
};

TEST(Restarted, WhatHadLeftThePictureBeforeARestartStaysWhereItWas) {
  for (const int full_turns : {0, 2}) {
    RestartedRobot restarted(3.0, {{5.2e5, 5.4e6}, 2.5}, full_turns), to_the_left = restarted;
    const Guarded& answer = restarted.asked(right);
    EXPECT_LT(answer.factor, 0.95) << answer.reason;
    EXPECT_EQ(answer.sensor, "memory");
    ASSERT_TRUE(answer.point);
    EXPECT_NEAR(answer.point->y, -0.9 + 0.087, 0.08);
    EXPECT_NEAR(answer.point->x, 0.0, 0.14);
    EXPECT_EQ(to_the_left.asked({0.0, 0.5, 0.0}).factor, 1.0) << "nothing is there";
    EXPECT_EQ(RestartedRobot().next.asked(right).factor, 1.0) << "of whom nothing is recalled";
  }
}

/// Killed a moment after odometry paused, before that has placed anything again.
TEST(Restarted, WhereTheyWereAsOdometryBrokeOffIsToldUntilItPlacesThemAgain) {
  for (const double spoke_again_for : {0.05, 0.1, 0.2, 0.5, 2.0}) {
    RestartedRobot restarted(1.0, {}, 0, spoke_again_for);
    const Guarded& answer = restarted.asked(right);
    EXPECT_LT(answer.factor, 0.95) << spoke_again_for << ": " << answer.reason;
    EXPECT_EQ(answer.sensor, "memory");
    ASSERT_TRUE(answer.point);
    EXPECT_NEAR(answer.point->y, -0.9 + 0.087, 0.15);
    EXPECT_NEAR(answer.point->x, 0.0, 0.2);
  }
}

/// Killed a moment after odometry jumped, by less than the robot may have gone until the next process hears of it.
TEST(Restarted, FromWhereOdometryHasJumpedNobodyPlacesThemAnyMore) {
  RobotWithOdometry robot, next;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.passes(0.5, robot.hall);
  robot.pose.place.x += 0.5;
  robot.passes(0.1, robot.hall);
  next.now = robot.now;
  next.pass(2.0);
  next.pose = robot.pose;
  ASSERT_TRUE(next.control.recall(robot.control.remembered()));
  const Guarded& answer = next.asked(right);
  EXPECT_EQ(answer.cause, Cause::NoOdometry);
  EXPECT_EQ(answer.reason,
            "odometry jumped or was wrong, and what was out of sight before this start cannot be placed");
  EXPECT_NE(answer.hint, "");
  EXPECT_EQ(next.control.remembered().back(), robot.control.remembered().back()) << "for the next one";
  next.passes(30.0, next.hall);
  EXPECT_EQ(next.asked(right).factor, 1.0) << next.wants(right).reason;
}

TEST(Restarted, WhereNothingWasNearAJumpKeepsNobodyFromDriving) {
  RobotWithOdometry robot;
  robot.passes(1.0, robot.hall);
  robot.pose.place.x += 0.5;
  robot.passes(0.1, robot.hall);
  EXPECT_EQ(robot.control.remembered().back(), "");
}

/// The next process hears it jump before that goes on for long enough to be asked.
TEST(Restarted, NorIfItJumpsBeforeTheyArePlaced) {
  RestartedRobot restarted(1.0);
  ASSERT_TRUE(restarted.next.control.recall(restarted.remembered));
  restarted.next.passes(0.1, restarted.next.hall);
  restarted.next.pose.place.x += 0.3;
  EXPECT_EQ(restarted.next.asked(right).cause, Cause::NoOdometry);
  restarted.next.control.forget_losses();
  EXPECT_EQ(restarted.next.asked(right).factor, 1.0) << restarted.next.wants(right).reason;
}

TEST(Restarted, WhatWasToldAsOdometryBrokeOffIsOverWithItsTimeOrReset) {
  for (const bool is_reset : {false, true}) {
    RestartedRobot restarted(1.0, {}, 0, 0.05);
    RobotWithOdometry& robot = restarted.robot;
    EXPECT_NE(robot.control.remembered().back(), "");
    robot.has_odometry = false;
    is_reset ? robot.control.forget_losses() : robot.passes(31.0, robot.hall);
    EXPECT_EQ(robot.control.remembered().back(), "");
  }
}

TEST(Restarted, TheRobotThatRolledOnMeanwhileKnowsThemWhereTheyAre) {
  RestartedRobot restarted;
  restarted.next.pose.place.x += 0.4;  // away from it, along its new left
  const Pose2 way = between(restarted.robot.pose, restarted.next.pose);
  const Guarded& answer = restarted.asked(right);
  ASSERT_TRUE(answer.point) << answer.reason;
  EXPECT_NEAR(answer.point->y, -0.9 + 0.087 - way.place.y, 0.12);
  EXPECT_NEAR(answer.point->x, -way.place.x, 0.14);
}

/// As a filter does that joins wheels and a camera.
TEST(Restarted, WhatOdometryHadCorrectedBeforeTheyWereSeenWidensNoneOfThem) {
  RobotWithOdometry robot;
  for (int i = 0; i < 30; ++i) {
    robot.pose.place.x += i % 2 == 0 ? 0.04 : -0.04;
    robot.passes(0.2, robot.hall);
  }
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  const auto kept = kept_places_in(robot.control.remembered().back());
  ASSERT_TRUE(kept);
  ASSERT_FALSE(kept->all.empty());
  for (const KeptPlace& one : kept->all) EXPECT_LT(one.off, 0.1);
}

TEST(Restarted, UntilOdometrySpeaksNobodyKnowsWhereTheyAre) {
  RestartedRobot restarted;
  restarted.next.has_odometry = false;
  EXPECT_EQ(restarted.asked(right).cause, Cause::NoOdometry);
  EXPECT_EQ(restarted.next.wants({0.1, 0.0, 0.0}).factor, 0.0);
  EXPECT_EQ(restarted.next.control.remembered(), restarted.remembered) << "for the next one to go on with";
  restarted.next.has_odometry = true;
  EXPECT_LT(restarted.next.asked(right).factor, 0.95);
}

TEST(Restarted, WhoNeverHearsOdometryForgetsThemOnceTheirTimeIsOver) {
  RestartedRobot restarted;
  restarted.next.has_odometry = false;
  EXPECT_EQ(restarted.asked(right).factor, 0.0);
  restarted.next.passes(30.0, restarted.next.hall);
  EXPECT_EQ(restarted.next.asked(right).factor, 1.0) << restarted.next.wants(right).reason;
}

TEST(Restarted, OdometryThatBeganAnewHasJumped) {
  RestartedRobot restarted(3.0, {{50.0, 20.0}, 1.0});
  restarted.next.pose = {};
  ASSERT_TRUE(restarted.next.control.recall(restarted.remembered));
  restarted.next.passes(0.15, restarted.next.hall);
  EXPECT_EQ(restarted.next.wants(right).cause, Cause::NoOdometry);
  EXPECT_EQ(restarted.next.asked(right).factor, 1.0) << "nobody knows any more";
  EXPECT_EQ(restarted.next.control.remembered().back(), "");
}

TEST(Restarted, ThoseOfLongAgoAreOver) {
  for (const double seconds : {31.0, -31.0, 86400.0}) {
    RestartedRobot restarted(seconds);
    EXPECT_EQ(restarted.asked(right).factor, 1.0) << seconds;
  }
}

TEST(Restarted, ResetForgetsThem) {
  RestartedRobot restarted;
  ASSERT_TRUE(restarted.next.control.recall(restarted.remembered));
  restarted.next.control.forget_losses();
  EXPECT_EQ(restarted.next.asked(right).factor, 1.0);
}

TEST(Restarted, WithoutOdometryNoneAreWritten) {
  RobotWithOdometry robot;
  robot.has_odometry = false;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  EXPECT_EQ(robot.control.remembered().back(), "");
}

/// It looks at them again and sees what is behind.
TEST(Restarted, WhatHasGoneMeanwhileIsSeenToBeGone) {
  RestartedRobot restarted;
  ASSERT_LT(restarted.asked(right).factor, 0.95);
  restarted.next.turns(-quarter, restarted.next.hall);
  restarted.next.passes(0.3, Scene({wall_before(1.5)}));
  restarted.next.turns(quarter, restarted.next.hall);
  EXPECT_EQ(restarted.next.asked(right).factor, 1.0) << restarted.next.wants(right).reason;
}

/// Its laser alone shows what stands behind it; odometry says that it stands.
struct RobotWithLaserBehind : RobotWithSensors {
  RobotWithLaserBehind() : RobotWithSensors(remembering_with_sensors()) { rear_shows = false; }

  static Settings remembering_with_sensors() {
    Settings settings = with_sensors();
    settings.memory_distance = 1.5;
    return settings;
  }

  void passes(double seconds) {
    for (double t = 0.0; t < seconds; t += 0.05) {
      control.note_odometry(now.ros, {}, {});
      drives_on({});
    }
  }

  void shows_behind(float range) {
    std::fill(ranges.begin(), ranges.begin() + 10, range);
    std::fill(ranges.end() - 10, ranges.end(), range);
  }
};

TEST(Restarted, WhatALaserShowedIsSeenToHaveGoneByItThoughACameraLooksFirst) {
  const Twist2 back{-0.3, 0.0, 0.0};
  RobotWithLaserBehind robot, next;
  robot.passes(1.0);
  robot.shows_behind(0.4f);
  robot.passes(1.0);
  ASSERT_LT(robot.wants(back).factor, 1.0) << robot.wants(back).reason;
  next.now = robot.now;
  ASSERT_TRUE(next.control.recall(robot.control.remembered()));
  next.laser_shows = false;
  next.passes(0.4);
  next.laser_shows = true;
  next.passes(0.05);
  EXPECT_LT(next.wants(back).factor, 1.0) << "not by one scan: " << next.wants(back).reason;
  next.passes(2.0);
  EXPECT_EQ(next.wants(back).factor, 1.0) << next.wants(back).reason;
}

}  // namespace
}  // namespace safety_control_cloud
