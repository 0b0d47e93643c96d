// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/odometry_check.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "guard/robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

/// What becomes of pose and twist until they are told; `from` is where that began.
using Says = std::function<void(const Pose2& from, Pose2& pose, Twist2& twist)>;

void rightly(const Pose2&, Pose2&, Twist2&) {}

void backward(const Pose2& from, Pose2& pose, Twist2& twist) {
  pose.place = from.place - (pose.place - from.place);
  twist.vx = -twist.vx;
}

void mirrored(const Pose2& from, Pose2& pose, Twist2& twist) {
  pose.heading = from.heading - (pose.heading - from.heading);
  twist.w = -twist.w;
}

void at_rest(const Pose2& from, Pose2& pose, Twist2& twist) { pose = from, twist = {}; }

/// It remembers what it has turned away from.
struct DrivenRobot : RobotWithOdometry {
  DrivenRobot() {
    passes(1.0, with_post);
    turns(quarter, hall);
    passes(1.2, hall);  // nobody told it to turn
  }

  double pace = 1.0;  ///< of ROS time

  /// The base does so large a share of what it is told, as far as it is let. Until nobody believes odometry any more.
  Guarded drives(double seconds, const Twist2& told, const Says& says, double share = 1.0) {
    const Pose2 from = pose;
    Guarded answer;
    for (double t = 0.0; t < seconds && answer.cause != Cause::NoOdometry; t += 0.05) {
      now.steady += 0.05 / pace, now.ros += 0.05;
      twist = limited(told, share * answer.factor);
      pose = beyond(pose, way_of(twist, 0.05));
      Pose2 there = pose;
      Twist2 then = twist;
      says(from, there, then);
      control.note_odometry(now.ros, there, then);
      see(hall);
      answer = wants(told);
    }
    return answer;
  }
};

TEST(OdometryCheck, StopsWhoRemembersByIt) {
  const std::pair<Twist2, Says> wrong[] = {
      {{0.3, 0.0, 0.0}, backward},
      {{0.3, 0.0, 0.2}, backward},
      {{0.3, 0.0, -0.6}, mirrored},
  };
  for (const auto& [told, says] : wrong) {
    DrivenRobot robot;
    const Guarded answer = robot.drives(4.0, told, says);
    EXPECT_EQ(answer.cause, Cause::NoOdometry) << told.w << ": " << answer.reason;
    EXPECT_EQ(answer.factor, 0.0);
    EXPECT_FALSE(answer.hint.empty());
    robot.control.forget_losses();
    robot.passes(0.2, robot.hall);
    EXPECT_EQ(robot.wants(told).cause, Cause::Seen) << "somebody has looked";
  }
}

/// Killed then, whatever odometry says to the next process.
TEST(OdometryCheck, WhoTakesOverStandsForAsLong) {
  DrivenRobot robot;
  const Twist2 told{0.3, 0.0, -0.6};
  ASSERT_EQ(robot.drives(4.0, told, mirrored).cause, Cause::NoOdometry);
  const auto remembered = robot.control.remembered();
  robot.passes(0.5, robot.hall);
  EXPECT_EQ(robot.control.remembered(), remembered) << "it is not written down all the time";
  RobotWithOdometry next;
  next.now = robot.now;
  ASSERT_TRUE(next.control.recall(remembered));
  next.passes(1.0, next.hall);
  EXPECT_EQ(next.wants({-0.3, 0.0, 0.0}).cause, Cause::NoOdometry);
  EXPECT_EQ(next.control.remembered(), remembered) << "for the one after that";
  next.passes(29.5, next.hall);
  EXPECT_EQ(next.wants({-0.3, 0.0, 0.0}).cause, Cause::Seen) << "after memory_time";
  EXPECT_EQ(next.control.remembered().back(), "");
  robot.control.forget_losses();
  EXPECT_EQ(robot.control.remembered().back(), "") << "somebody has looked";
}

TEST(OdometryCheck, ContradictionIsNoneOfABaseThatDoesLessOrWasHalted) {
  for (const Twist2& told :
       {Twist2{0.3, 0.0, 0.0}, Twist2{0.3, 0.0, -0.6}, Twist2{-0.3, 0.0, 0.3}, Twist2{0.0, 0.0, 1.5}}) {
    for (const double share : {1.0, 0.4, 0.0}) {
      DrivenRobot robot;
      EXPECT_EQ(robot.drives(4.0, told, rightly, share).cause, Cause::Seen)
          << told.vx << ", " << told.w << ", " << share;
    }
    DrivenRobot robot;
    EXPECT_EQ(robot.drives(4.0, told, at_rest).cause, Cause::Seen) << told.vx << ", " << told.w;
  }
}

/// All the time by as much, so that every place lies where it does not.
TEST(OdometryCheck, IsThatItJumpsAfterItStoodThoughTheBaseWasToldToGo) {
  const Twist2 ahead{0.3, 0.0, 0.0};
  for (const bool told_to_go : {true, false}) {
    for (const double jump : {0.8, -7.0}) {
      DrivenRobot robot;
      robot.drives(2.0, ahead, rightly);
      if (told_to_go)
        robot.drives(2.0, ahead, at_rest);
      else
        robot.passes(2.0, robot.hall);
      robot.pose.place.x += jump;
      robot.passes(1.0, robot.hall);
      const Guarded answer = robot.wants(ahead);
      EXPECT_EQ(answer.cause, told_to_go ? Cause::NoOdometry : Cause::Seen) << jump << ": " << answer.reason;
      if (!told_to_go) continue;
      EXPECT_NE(answer.reason.find("it stood while"), std::string::npos) << answer.reason;
      robot.passes(31.0, robot.hall);
      EXPECT_EQ(robot.wants(ahead).cause, Cause::Seen) << "after memory_time";
    }
  }
}

/// Whoever pressed the stop button, and a driver that paused.
TEST(OdometryCheck, ContradictionIsNoneIfAfterAPauseItStillStandsWhereItStood) {
  DrivenRobot robot;
  robot.drives(2.0, {0.3, 0.0, 0.0}, rightly);
  robot.drives(2.0, {0.3, 0.0, 0.0}, rightly, 0.0);
  robot.pass(0.4);
  robot.passes(1.0, robot.hall);
  EXPECT_EQ(robot.wants({0.3, 0.0, 0.0}).cause, Cause::Seen);
}

TEST(OdometryCheck, ContradictionIsNoneForAMomentNorOfASlowSimulation) {
  const Twist2 ahead{0.3, 0.0, 0.0};
  {
    DrivenRobot robot;
    EXPECT_EQ(robot.drives(2.0, ahead, rightly).cause, Cause::Seen);
    const Guarded pushed = robot.drives(1.4, ahead, backward);
    EXPECT_EQ(pushed.cause, Cause::Seen) << pushed.reason;
    EXPECT_EQ(robot.drives(2.0, ahead, rightly).cause, Cause::Seen);
  }
  for (const double pace : {0.2, 0.3, 0.5}) {
    DrivenRobot robot;
    robot.pace = pace;
    for (int i = 0; i < 6; ++i)
      EXPECT_EQ(robot.drives(2.0, i % 2 == 0 ? ahead : Twist2{-0.3, 0.0, 0.0}, rightly).cause, Cause::Seen) << pace;
  }
}

}  // namespace
}  // namespace safety_control_cloud
