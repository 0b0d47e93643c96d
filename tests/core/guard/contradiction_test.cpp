// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/contradiction.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <utility>

#include "robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

/// Ways between which a base went that did as it was told.
std::vector<Pose2> between_ways(const Pose2& a, const Pose2& b) {
  return {a, b, {a.place, b.heading}, {b.place, a.heading}};
}

bool contradicts(const Pose2& way, const std::vector<Pose2>& as_told) {
  return compared(way, as_told).contradiction.has_value();
}

TEST(Contradiction, IsAWayAgainstAllThatTheBaseWasTold) {
  const auto ahead = between_ways({{0.2, 0.0}, -0.05}, {{0.5, 0.0}, 0.05});
  EXPECT_TRUE(contradicts({{-0.3, 0.0}, 0.0}, ahead));
  for (const double x : {-0.02, 0.0, 0.1, 0.3, 0.9}) EXPECT_FALSE(contradicts({{x, 0.0}, 0.0}, ahead)) << x;
  EXPECT_FALSE(contradicts({{-0.3, 0.0}, 0.0}, between_ways({{-0.1, 0.0}, 0.0}, {{0.5, 0.0}, 0.0}))) << "perhaps";
  EXPECT_FALSE(contradicts({{-0.3, 0.0}, 0.0}, between_ways({{0.05, 0.0}, 0.0}, {{0.5, 0.0}, 0.0}))) << "hardly told";
  EXPECT_FALSE(contradicts({{-0.3, 0.0}, 1.3}, between_ways({{0.2, 0.0}, 1.0}, {{0.5, 0.0}, 2.0}))) << "turns far";
  EXPECT_FALSE(contradicts({{-0.3, 0.0}, 0.0}, {})) << "nothing told";
  EXPECT_TRUE(compared({{0.3, 0.0}, 0.0}, ahead).agrees);
  for (const double x : {-0.3, 0.0, 0.02}) EXPECT_FALSE(compared({{x, 0.0}, 0.0}, ahead).agrees) << x;
  EXPECT_FALSE(compared({{0.3, 0.0}, 0.0}, {}).agrees);
  const auto backward = between_ways({{-0.2, 0.0}, 0.0}, {{-0.5, 0.0}, 0.0});
  EXPECT_TRUE(contradicts({{0.3, 0.0}, 0.0}, backward));
  EXPECT_FALSE(contradicts({{-0.3, 0.0}, 0.0}, backward));
  const auto left = between_ways({{0.0, 0.2}, 0.0}, {{0.0, 0.5}, 0.0});
  EXPECT_TRUE(contradicts({{0.0, -0.3}, 0.0}, left));
  EXPECT_FALSE(contradicts({{0.0, 0.3}, 0.0}, left));
}

TEST(Contradiction, IsATurnAgainst) {
  const auto turning = between_ways({{0.2, 0.0}, 0.4}, {{0.5, 0.1}, 0.8});
  EXPECT_TRUE(contradicts({{0.3, 0.0}, -0.5}, turning));
  EXPECT_FALSE(contradicts({{0.3, 0.0}, 0.1}, turning));
  EXPECT_FALSE(contradicts({{0.3, 0.0}, 0.0}, turning)) << "some do not turn so slowly";
  EXPECT_FALSE(contradicts({{0.0, 0.0}, 0.0}, turning)) << "it rests: somebody may have pressed its stop button";
  EXPECT_FALSE(contradicts({{0.3, 0.0}, -0.5}, between_ways({{0.2, 0.0}, 0.1}, {{0.5, 0.1}, 0.8}))) << "hardly told";
}

TEST(Contradiction, StoodIsWhoDidNeitherThoughTheBaseWasToldTo) {
  const auto ahead = between_ways({{0.2, 0.0}, -0.05}, {{0.5, 0.0}, 0.05});
  const auto turning = between_ways({{0.0, 0.0}, 0.4}, {{0.0, 0.0}, 0.8});
  EXPECT_TRUE(compared({}, ahead).stood);
  EXPECT_TRUE(compared({}, turning).stood);
  EXPECT_FALSE(compared({{0.03, 0.0}, 0.0}, ahead).stood);
  EXPECT_FALSE(compared({{0.0, 0.0}, 0.03}, turning).stood);
  EXPECT_FALSE(compared({}, between_ways({}, {{0.5, 0.0}, 0.0})).stood) << "perhaps it was to stand";
  EXPECT_FALSE(compared({}, {}).stood);
}

TEST(Contradiction, HasStoodUntilItAgreesAgain) {
  const Compared stood{false, {}, true}, along{true, {}}, neither;
  Contradictions all;
  double now = 100.0;
  const auto has_stood_after = [&](const Compared& one, double seconds) {
    for (double t = 0.0; t < seconds; t += 0.05) all.note(one, now += 0.05);
    return all.has_stood();
  };
  EXPECT_FALSE(has_stood_after(along, 2.0));
  EXPECT_FALSE(has_stood_after(stood, 0.2));
  EXPECT_TRUE(has_stood_after(stood, 0.2));
  EXPECT_TRUE(has_stood_after(neither, 20.0));
  EXPECT_FALSE(has_stood_after(along, 0.05));
}

TEST(Contradiction, PrevailsWhereItIsMostOfWhatCanBeCompared) {
  const Compared against{false, "backward"}, along{true, {}}, neither;
  const auto after = [&](std::initializer_list<std::pair<Compared, double>> each) {
    Contradictions all;
    double now = 100.0;
    for (const auto& [one, seconds] : each)
      for (double t = 0.0; t < seconds; t += 0.05) all.note(one, now += 0.05);
    return all.prevail();
  };
  EXPECT_FALSE(after({{neither, 5.0}}));
  EXPECT_FALSE(after({{against, 0.2}}));
  EXPECT_TRUE(after({{against, 0.5}}));
  EXPECT_FALSE(after({{along, 2.0}, {against, 1.4}})) << "pushed";
  EXPECT_TRUE(after({{along, 2.0}, {against, 4.0}}));
  EXPECT_TRUE(after({{along, 5.0}, {neither, 60.0}, {against, 0.5}})) << "long ago";
}

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

TEST(Contradiction, StopsWhoRemembersByIt) {
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

TEST(Contradiction, IsNoneOfABaseThatDoesLessOrWasHalted) {
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
TEST(Contradiction, IsThatItJumpsAfterItStoodThoughTheBaseWasToldToGo) {
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
TEST(Contradiction, IsNoneIfAfterAPauseItStillStandsWhereItStood) {
  DrivenRobot robot;
  robot.drives(2.0, {0.3, 0.0, 0.0}, rightly);
  robot.drives(2.0, {0.3, 0.0, 0.0}, rightly, 0.0);
  robot.pass(0.4);
  robot.passes(1.0, robot.hall);
  EXPECT_EQ(robot.wants({0.3, 0.0, 0.0}).cause, Cause::Seen);
}

TEST(Contradiction, IsNoneForAMomentNorOfASlowSimulation) {
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
