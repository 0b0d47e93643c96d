// SPDX-License-Identifier: BSD-3-Clause
// What a robot without odometry drove up to until it was too near to be seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

constexpr double period = 0.05;          ///< [s]
constexpr double front = 0.178 + 0.087;  ///< [m] of the robot before its camera

const Twist2 ahead{0.2, 0.0, 0.0}, about{0.0, 0.0, 0.5}, back{-0.05, 0.0, 0.0};

Scene post_at(double ahead) { return Scene({post(static_cast<float>(ahead), 0.02f, 0.06f)}); }
Scene board_at(double ahead) { return Scene({{static_cast<float>(ahead), -0.3f, 0.3f, -0.3f, 0.05f}}); }

/// A base that obeys so many clouds later, and gains and loses speed at these rates [m/s2].
struct Base {
  std::size_t late;
  double gains, loses;
  double speed = 0.0;
  std::deque<double> told = {};

  void is_told(double wish) {
    told.push_back(wish);
    const double aim = told.size() > late ? told[told.size() - 1 - late] : 0.0;
    speed += std::clamp(aim - speed, -loses * period, gains * period);
  }
};

const Base prompt{0, 1e3, 1e3}, lazy{3, 0.3, 0.36}, late{3, 1e3, 0.36};

struct RobotBefore : RobotWithOdometry {
  RobotBefore(Scene (*shown)(double), Base driven) : RobotWithOdometry(), at(shown), base(std::move(driven)) {
    has_odometry = false;
  }

  Scene (*at)(double);
  Base base;
  double left = 0.9;     ///< [m] from the camera to what stands there
  double nearest = 0.9;  ///< [m] so far

  void wants_for(double seconds, const Twist2& wish) {
    for (double t = 0.0; t < seconds; t += period) {
      const Guarded& answer = drives_on(at(left), wish);
      base.is_told(answer.factor * wish.vx);
      left -= period * base.speed;
      nearest = std::min(nearest, left);
    }
  }

  /// Until that is lost from sight, and the robot stands.
  void drives_up() {
    wants_for(8.0, ahead);
    ASSERT_LT(left, 0.4);
    wants_for(0.5, {});
  }
};

TEST(ReckonedLoss, ClosesOnlyTheWayThereIfItsPlaceIsKnown) {
  for (const Base& base : {prompt, lazy}) {
    for (const auto shown : {post_at, board_at}) {
      RobotBefore robot(shown, base);
      robot.drives_up();
      EXPECT_EQ(robot.wants(about).factor, 1.0) << robot.wants(about).reason;
      const Guarded& answer = robot.wants({0.7, 0.0, 0.0});
      EXPECT_LE(answer.factor * 0.7, 0.1 + 1e-9) << answer.reason;
    }
  }
}

TEST(ReckonedLoss, IsNeverTouchedWhicheverWayTheBaseObeys) {
  for (const Base& base : {prompt, lazy, late}) {
    for (const auto shown : {post_at, board_at}) {
      RobotBefore robot(shown, base);
      robot.drives_up();
      for (int i = 0; i < 10; ++i) {  // again and again, as somebody does who tries to hit it
        robot.wants_for(0.3, {0.0, 0.0, 0.0});
        robot.wants_for(1.0, ahead);
      }
      EXPECT_GT(robot.nearest, front + 0.01);
    }
  }
}

/// Its wheels turn, or do not, and nobody measures it.
TEST(ReckonedLoss, OfARobotThatMayNotHaveGoneBackIsUnknown) {
  RobotBefore robot(post_at, prompt);
  robot.drives_up();
  ASSERT_EQ(robot.wants({}).cause, Cause::Seen);
  robot.drives_on(robot.at(robot.left), back);
  robot.wants_for(0.5, {});
  for (const Twist2& wish : {ahead, about}) {
    EXPECT_EQ(robot.wants(wish).factor, 0.0);
    EXPECT_EQ(robot.wants(wish).cause, Cause::NearLoss);
  }
}

TEST(ReckonedLoss, OfARobotThatDoesNotTurnAsItIsToldIsUnknown) {
  RobotBefore robot(post_at, prompt);
  robot.drives_up();
  for (double t = 0.0; t < 1.5; t += period) robot.drives_on(robot.at(robot.left), {0.0, 0.0, 0.5});
  EXPECT_EQ(robot.wants(about).cause, Cause::NearLoss);
  EXPECT_EQ(robot.wants(about).factor, 0.0);
}

TEST(ReckonedLoss, OfARobotThatSomebodyElseCommandedIsUnknown) {
  RobotBefore robot(post_at, prompt);
  robot.drives_up();
  robot.control.note_outside(Doubt{Cause::TwoCommanders, "somebody else"});
  robot.wants_for(0.2, {});
  robot.control.note_outside(std::nullopt);
  robot.wants_for(0.2, {});
  EXPECT_EQ(robot.wants(about).cause, Cause::NearLoss);
  EXPECT_EQ(robot.wants(about).factor, 0.0);
}

TEST(ReckonedLoss, IsUnknownInTheFrameOfOdometryThatBegins) {
  RobotBefore robot(post_at, prompt);
  robot.drives_up();
  robot.has_odometry = true;
  robot.pose = {{0.9 - robot.left, 0.0}, 0.0};  // where it took itself to be, by chance
  robot.passes(0.5, robot.at(robot.left));
  EXPECT_EQ(robot.wants(about).cause, Cause::NearLoss);
  EXPECT_EQ(robot.wants(about).factor, 0.0);
}

TEST(ReckonedLoss, BesideWhichSomethingElseHidesTheFloorIsUnknown) {
  RobotBefore robot(post_at, prompt);
  robot.drives_up();
  const auto near = static_cast<float>(robot.left);
  robot.passes(0.2, Scene({post(near, 0.02f, 0.06f), post(near, -0.1f)}));
  EXPECT_EQ(robot.wants(about).cause, Cause::NearLoss);
  EXPECT_EQ(robot.wants(about).factor, 0.0);
}

}  // namespace
}  // namespace safety_control_cloud
