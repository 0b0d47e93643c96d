// SPDX-License-Identifier: BSD-3-Clause
// A low box whose front has left the picture at its lower border, before a guarded robot: it came to it, or was pushed
// to it.
#include "../../../safety_control_cloud/core/guard/looked_over.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../memory/lens.hpp"
#include "robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

/// A wide and low picture, whose lower border leaves the corridor 0.92 m before the camera.
const Lens low = Lens().part(0, 30, 160, 60);
const Board behind = {3.0f, -9.0f, 9.0f, -9.0f, floor_y};
constexpr float height = 0.16f, depth = 0.5f;
constexpr float front_leaves = (floor_y - height) / 0.2165f;  // [m] ahead of the camera

/// From its front on.
std::vector<Board> box(float front) {
  std::vector<Board> boards{behind};
  for (float z = front; z <= front + depth; z += 0.004f) boards.push_back({z, -0.2f, 0.2f, floor_y - height, floor_y});
  return boards;
}

struct RobotWithLowPicture : GuardedRobot {
  bool has_odometry;
  Pose2 pose;

  explicit RobotWithLowPicture(bool odometry) : GuardedRobot(remembering()), has_odometry(odometry) {}

  const Guarded& shows(const std::vector<Board>& boards, const Twist2& wanted) {
    pass(0.05);
    if (has_odometry) control.note_odometry(now.ros, pose, {});
    const auto points = low.points(boards);
    see(low.view_of_rows(points));
    return wants(wanted);
  }
  void looks(double seconds, const std::vector<Board>& boards) {
    for (double t = 0.0; t < seconds; t += 0.05) shows(boards, {});
  }
  void is_approached(float from, float until, float step) {
    for (float front = from; front > until; front -= step) shows(box(front), {});
  }
  void drives_up(float from, float until, float step) {
    for (float front = from; front > until; front -= step) {
      pose.place.x += has_odometry ? step : 0.0f;
      shows(box(front), {step / 0.05, 0.0, 0.0});
    }
  }
};

const Twist2 ahead{0.2, 0.0, 0.0};

TEST(LookedOver, WhatWasPushedThereStopsWhoDrivesAtIt) {
  for (const bool odometry : {true, false}) {
    for (const float step : {0.005f, 0.01f, 0.03f}) {
      RobotWithLowPicture robot(odometry);
      robot.looks(0.5, {behind});
      robot.is_approached(1.3f, front_leaves - 0.1f, step);
      robot.looks(2.0, box(front_leaves - 0.1f));
      const Guarded& answer = robot.shows(box(front_leaves - 0.1f), ahead);
      EXPECT_EQ(answer.factor, 0.0) << step << ": " << answer.reason;
      EXPECT_EQ(answer.cause, Cause::NearLoss);
      EXPECT_NE(answer.hint, "");
      EXPECT_GT(robot.shows(box(front_leaves - 0.1f), {-0.1, 0.0, 0.0}).factor, 0.0);
    }
  }
}

TEST(LookedOver, WhoDroveThereKnowsWhereItsFrontIs) {
  RobotWithLowPicture robot(true);
  robot.looks(0.5, box(1.3f));
  robot.drives_up(1.3f, front_leaves - 0.1f, 0.01f);
  robot.looks(2.0, box(front_leaves - 0.1f));
  const Guarded& answer = robot.shows(box(front_leaves - 0.1f), ahead);
  EXPECT_EQ(answer.cause, Cause::Seen) << answer.reason;
  EXPECT_GT(answer.factor, 0.0) << answer.reason;
}

TEST(LookedOver, OfWhatWasThereFromTheStartNobodyKnows) {
  for (const bool odometry : {true, false}) {
    RobotWithLowPicture robot(odometry);
    robot.looks(1.0, box(front_leaves - 0.1f));
    EXPECT_EQ(robot.shows(box(front_leaves - 0.1f), ahead).factor, 0.0);
    robot.control.forget_losses();
    EXPECT_GT(robot.shows(box(front_leaves - 0.1f), ahead).factor, 0.0) << "somebody has looked";
  }
}

/// A picture or two without it are noise.
TEST(LookedOver, ItIsFreeASecondAfterThatHasGone) {
  RobotWithLowPicture robot(true);
  robot.looks(0.5, box(front_leaves - 0.1f));
  robot.looks(0.8, {behind});
  EXPECT_EQ(robot.shows({behind}, ahead).factor, 0.0);
  robot.looks(0.5, {behind});
  EXPECT_EQ(robot.shows({behind}, ahead).factor, 1.0) << robot.wants(ahead).reason;
}

TEST(LookedOver, AFrontIsAtMostAsFarAsItsTopIsSeen) {
  const Point2 eye{-0.1, 0.0}, end{0.6, 0.1};
  const auto is_unknown_with = [&](const Point2& place, double off) {
    LookedOver over;
    over.note({end}, eye, {{place, 0.1, {}, off, 1.0}}, 1.0);
    return over.is_unknown();
  };
  EXPECT_FALSE(is_unknown_with(end, 0.01));
  EXPECT_FALSE(is_unknown_with({0.4, 0.07}, 0.01));
  EXPECT_TRUE(is_unknown_with({0.65, 0.107}, 0.01)) << "behind it";
  EXPECT_FALSE(is_unknown_with({0.63, 0.105}, 0.1)) << "or maybe not";
  EXPECT_TRUE(is_unknown_with({0.5, 0.2}, 0.01)) << "beside it";
  EXPECT_TRUE(is_unknown_with({-0.3, -0.03}, 0.01)) << "behind the camera";
}

TEST(LookedOver, ItIsAskedAboutAsItBegins) {
  const KnownPlace front{{0.6, 0.0}, 0.1, {}, 0.01, 1.0};
  LookedOver over;
  over.note({{0.6, 0.0}}, {}, {}, 1.0);
  over.note({{0.6, 0.0}}, {}, {front}, 1.5);
  EXPECT_TRUE(over.is_unknown()) << "its top has rested by then";
  over.note({}, {}, {}, 2.4);
  over.note({{0.6, 0.0}}, {}, {front}, 2.5);
  EXPECT_TRUE(over.is_unknown()) << "noise took it away";
  over.note({}, {}, {}, 3.6);
  EXPECT_FALSE(over.is_unknown());
  over.note({{0.6, 0.0}}, {}, {front}, 3.7);
  EXPECT_FALSE(over.is_unknown());
}

}  // namespace
}  // namespace safety_control_cloud
