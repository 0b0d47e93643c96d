// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "driving_up.hpp"

namespace safety_control_cloud {
namespace {

TEST(Blindness, BeforeAWallThatIsKnownClosesOnlyTheWayAhead) {
  RobotWithOdometry robot, without;
  without.has_odometry = false;
  for (RobotWithOdometry* one : {&robot, &without}) drives_up(*one, wall_at);
  EXPECT_GT(robot.wants(about).factor, 0.0) << robot.wants(about).reason;
  EXPECT_GT(robot.wants(away).factor, 0.0) << robot.wants(away).reason;
  const Guarded& answer = robot.wants({0.02, 0.0, 0.3});
  EXPECT_EQ(answer.factor, 0.0);
  EXPECT_EQ(answer.cause, Cause::Blind) << "somebody may have stepped between";
  ASSERT_EQ(answer.doubts.size(), std::size_t{1});
  EXPECT_NE(answer.doubts[0].find("BLIND"), std::string::npos) << answer.doubts[0];
  EXPECT_EQ(without.wants(about).cause, Cause::Blind);
  EXPECT_EQ(without.wants(about).factor, 0.0);
}

TEST(Blindness, OfWhichOnlyAPartIsKnownClosesAllButTheWayBack) {
  RobotWithOdometry post, none;
  drives_up(post, board_at);
  none.passes(1.0, none.hall);
  for (RobotWithOdometry* robot : {&post, &none}) {
    robot->passes(0.3, wall_at(0.3f));
    EXPECT_EQ(robot->wants(about).cause, Cause::Blind);
    EXPECT_EQ(robot->wants(about).factor, 0.0);
    EXPECT_EQ(robot->wants({-0.05, 0.0, 0.0}).factor, 1.0) << robot->wants({-0.05, 0.0, 0.0}).reason;
  }
}

/// Over the wall's top a quarter of the picture returns: this is no camera that sees nothing for what it stands before.
TEST(Blindness, OfACameraThatReturnsMuchIsOfAnotherCause) {
  Settings settings = remembering();
  settings.min_valid_ratio = 0.9;
  RobotWithOdometry robot(settings);
  drives_up(robot, [](float ahead) {
    return Scene({{3.0f, -9.0f, 9.0f, -9.0f, floor_y}, {ahead, -9.0f, 9.0f, -0.08f, floor_y}});
  });
  EXPECT_EQ(robot.wants(about).cause, Cause::Blind);
  EXPECT_EQ(robot.wants(about).factor, 0.0);
}

TEST(Blindness, OutlivesAChangeOfSettings) {
  const Twist2 back{-0.05, 0.0, 0.0};
  RobotWithOdometry robot, without;
  without.has_odometry = false;
  for (RobotWithOdometry* one : {&robot, &without}) {
    drives_up(*one, wall_at);
    one->control.adopt(remembering(1.4));
    for (const Twist2& wish : {about, back}) EXPECT_EQ(one->wants(wish).cause, Cause::NoCloud);
    one->passes(0.3, wall_at(0.36f));
    EXPECT_EQ(one->wants(back).factor, 1.0) << one->wants(back).reason;
    EXPECT_EQ(one->wants(ahead).factor, 0.0);
  }
  EXPECT_GT(robot.wants(about).factor, 0.0) << robot.wants(about).reason;
  EXPECT_EQ(without.wants(about).factor, 0.0);
}

/// What is known lies before it no more, and it is dark still.
TEST(Blindness, ThatGoesOnWhereTheWallIsNotIsOfAnotherCause) {
  RobotWithOdometry robot;
  drives_up(robot, wall_at);
  ASSERT_GT(robot.wants(about).factor, 0.0);
  robot.turns(quarter, wall_at(0.3f));
  EXPECT_EQ(robot.wants(about).cause, Cause::Blind);
  EXPECT_EQ(robot.wants(about).factor, 0.0);
}

}  // namespace
}  // namespace safety_control_cloud
