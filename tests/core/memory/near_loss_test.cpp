// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/near_loss.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

const Board hanging_board = {0.0f, -0.2f, 0.2f, -0.2f, 0.05f};

Board hanging(float z) {
  Board board = hanging_board;
  board.z = z;
  return board;
}

TEST(NearLoss, RobotDrivesThroughAnEmptyHall) {
  Robot robot;
  for (int i = 0; i < 20; ++i) {
    const Decision decision = robot.sees(Scene());
    EXPECT_EQ(decision.cause, Cause::Seen);
    EXPECT_EQ(decision.speed, 0.2);
  }
}

TEST(NearLoss, RobotStandsForAPostThatComesTooNearToBeSeen) {
  Robot robot;
  for (const float z : {0.7f, 0.6f, 0.5f, 0.42f}) robot.sees({post(z, 0.0f)});
  for (const float z : {0.39f, 0.3f, 0.2f}) {
    const Decision decision = robot.sees({post(z, 0.0f)});
    EXPECT_EQ(decision.cause, Cause::NearLoss) << z;
    EXPECT_EQ(decision.speed, 0.0) << z;
  }
}

TEST(NearLoss, RobotStandsForAPostThatJumpsFromWarningToTooNear) {
  Robot robot;
  robot.sees({post(0.7f, 0.0f)});
  const Decision decision = robot.sees({post(0.35f, 0.0f)});
  EXPECT_EQ(decision.cause, Cause::NearLoss);
  EXPECT_EQ(decision.speed, 0.0) << "0.7 m would be Warning, but it can only have come nearer";
}

TEST(NearLoss, RobotDrivesOnWhenALegThatHidLittleMoreThanTheNearestFloorHasGone) {
  Robot robot;
  robot.sees(Scene());
  robot.sees({post(0.67f, 0.0f, 0.1f)});
  EXPECT_EQ(robot.sees(Scene()).speed, 0.2) << "it stood on the floor, and the floor is seen again";
}

TEST(NearLoss, RobotDrivesOnWhenAPostThatOnlyReachedDownToTheNearFloorHasGone) {
  for (const float z : {0.69f, 0.70f, 0.71f, 0.72f, 0.73f, 0.74f, 0.745f}) {
    Robot robot;
    robot.sees(Scene());
    EXPECT_LE(robot.sees({post(z, 0.0f, 0.1f)}).speed, 0.1) << z;
    EXPECT_EQ(robot.sees({post(0.35f, 0.0f, 0.1f)}).speed, 0.0) << z << ": nearer, it hides the floor";
    EXPECT_EQ(robot.sees(Scene()).speed, 0.2) << z;
  }
}

TEST(NearLoss, RobotStandsForABoardThatHungShortOfTheNearFloorAboveAKerb) {
  const Board kerb = {0.73f, -0.2f, 0.2f, 0.21f, floor_y};
  Robot robot;
  robot.sees(Scene());
  robot.sees({{0.72f, -0.2f, 0.2f, -0.2f, 0.15f}, kerb});
  for (int i = 0; i < 40; ++i) EXPECT_EQ(robot.sees({{0.39f, -0.2f, 0.2f, -0.2f, 0.15f}}).speed, 0.0);
}

TEST(NearLoss, RobotThatWentOverABumpStillDrivesOnWhenALegHasGone) {
  Robot robot;
  for (int i = 0; i < 6; ++i) robot.sees(Scene({}, 0.03f));
  for (int i = 0; i < 20; ++i) robot.sees(Scene());
  for (const float x : {-0.1f, 0.0f, 0.1f}) robot.sees({post(0.5f, x, 0.1f)});
  EXPECT_EQ(robot.sees(Scene()).speed, 0.2) << "the floor is where it was before the bump";
}

TEST(NearLoss, RobotDrivesOnWhenTwoLegsHaveGoneOfWhichOneCameWhileTheOtherHidTheFloor) {
  Robot robot;
  robot.sees(Scene());
  robot.sees({post(0.3f, -0.08f)});
  robot.sees({post(0.3f, -0.08f), post(0.45f, 0.1f)});
  EXPECT_EQ(robot.sees({post(0.3f, -0.08f), post(0.35f, 0.1f)}).speed, 0.0);
  EXPECT_EQ(robot.sees(Scene()).speed, 0.2);
}

TEST(NearLoss, RobotStandsForAHangingBoardThatComesTooNearToBeSeen) {
  Robot robot;
  for (const float z : {0.7f, 0.6f, 0.5f, 0.42f}) robot.sees({hanging(z)});
  for (int i = 0; i < 40; ++i) {
    const Decision decision = robot.sees({hanging(0.35f)});
    EXPECT_EQ(decision.cause, Cause::NearLoss) << "the floor below it was never hidden and says nothing";
    EXPECT_EQ(decision.speed, 0.0);
  }
}

TEST(NearLoss, RobotGoesOnWhenSomethingIsSeenBehind) {
  Robot robot;
  robot.sees({hanging(0.45f)});
  robot.sees({hanging(0.35f)});
  const Board wall = {2.0f, -3.0f, 3.0f, -3.0f, floor_y};
  const Decision decision = robot.sees({wall});
  EXPECT_EQ(decision.cause, Cause::Seen);
  EXPECT_EQ(decision.speed, 0.2);
}

TEST(NearLoss, RobotGoesOnAfterSomebodyWalkedPastInAHallDeeperThanTheSensor) {
  Robot robot;
  robot.sees(Scene());
  for (float x = -0.5f; x < 0.5f; x += 0.03f) {
    const Decision decision = robot.sees({post(0.5f, x, 0.12f), post(0.55f, x + 0.25f, 0.12f)});
    EXPECT_LE(decision.speed, std::abs(x) < 0.2f ? 0.1 : 0.2) << x;
  }
  EXPECT_EQ(robot.sees(Scene()).cause, Cause::Seen);
  EXPECT_EQ(robot.sees(Scene()).speed, 0.2);
}

TEST(NearLoss, RobotGoesOnAfterItWasMovedBackFromACabinet) {
  Robot robot;
  const Board cabinet_near = {0.48f, -0.225f, 0.225f, -0.75f, floor_y};
  const Board cabinet_far = {2.5f, -0.225f, 0.225f, -0.75f, floor_y};
  robot.sees({cabinet_far});
  EXPECT_EQ(robot.sees({cabinet_near}).zone, Zone::Danger);
  EXPECT_EQ(robot.sees({cabinet_far}).zone, Zone::Safe);
}

TEST(NearLoss, OneNoisyPixelThatVanishesIsNoObstacle) {
  Robot robot;
  Scene noisy;
  noisy.set(20, 80, 0.45f);
  EXPECT_EQ(robot.sees(noisy).zone, Zone::Danger) << "while it is there, one point is an obstacle";
  EXPECT_EQ(robot.sees(Scene()).speed, 0.2);
}

TEST(NearLoss, FlickeringEdgeDoesNotMakeAnObstacleNearerThanItIs) {
  Robot robot;
  robot.sees({{0.7f, -0.1f, 0.1f, -1.0f, floor_y}});
  const Decision decision = robot.sees({{0.7f, -0.1f, 0.08f, -1.0f, floor_y}});
  EXPECT_EQ(decision.zone, Zone::Warning);
}

TEST(NearLoss, LossIsForgottenByHandAndAfterTheTimeoutOnly) {
  Robot robot;
  robot.sees({hanging(0.45f)});
  robot.waits(3600.0);
  EXPECT_EQ(robot.sees({hanging(0.35f)}).speed, 0.0);
  robot.control().forget_losses();
  EXPECT_EQ(robot.sees(Scene()).speed, 0.2);

  Settings settings;
  settings.near_loss.timeout = 1.0;
  Robot impatient(settings);
  impatient.sees({hanging(0.45f)});
  EXPECT_EQ(impatient.sees({hanging(0.35f)}).speed, 0.0);
  impatient.waits(0.9);
  EXPECT_EQ(impatient.sees({hanging(0.35f)}).speed, 0.0);
  impatient.waits(0.1);
  EXPECT_EQ(impatient.sees({hanging(0.35f)}).speed, 0.2);
}

/// The wall filled the picture, so every pixel of the strip between the two limits has seen "not in the corridor".
TEST(NearLoss, WhatWasSeenBesideTheOldCorridorSaysNothingOfANewOne) {
  Settings narrow, wide;
  narrow.corridor.x_max = 0.1f;
  Robot robot(narrow);
  const Board beside = {0.5f, 0.15f, 0.25f, -0.3f, 0.1f};
  robot.sees(Scene({beside}));
  robot.control().adopt(wide);
  EXPECT_EQ(robot.sees(Scene({beside})).cause, Cause::Seen);
  EXPECT_EQ(robot.sees(Scene({{0.39f, 0.15f, 0.25f, -0.3f, 0.1f}})).cause, Cause::NearLoss);
}

TEST(NearLoss, WhatIsLostStaysLostUnderAnotherCorridor) {
  Robot robot;
  robot.sees(Scene({{0.45f, -0.2f, 0.2f, -0.3f, 0.05f}}));
  EXPECT_EQ(robot.sees(Scene()).cause, Cause::NearLoss);
  Settings wide;
  wide.corridor.x_max = 0.4f;
  robot.control().adopt(wide);
  EXPECT_EQ(robot.sees(Scene()).cause, Cause::NearLoss);
  EXPECT_EQ(robot.sees(Scene()).speed, 0.0);
}

TEST(NearLoss, SaysSinceWhenTheRobotIsStuck) {
  Robot robot;
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(robot.sees({hanging(0.45f)}).stuck_since);
  const auto since = robot.sees({hanging(0.35f)}).stuck_since;
  ASSERT_TRUE(since);
  for (int i = 0; i < 9; ++i) EXPECT_EQ(robot.sees({hanging(0.35f)}).stuck_since, since);
  EXPECT_FALSE(robot.sees({hanging(0.45f)}).stuck_since);
  EXPECT_GT(robot.sees({hanging(0.35f)}).stuck_since, since);
}

TEST(NearLoss, MemoryCanBeSwitchedOff) {
  Settings settings;
  settings.near_loss.distance = 0.0;
  Robot robot(settings);
  robot.sees({hanging(0.45f)});
  EXPECT_EQ(robot.sees({hanging(0.35f)}).speed, 0.2);
}

TEST(NearLoss, LossOutlivesAChangeOfResolution) {
  Robot robot;
  robot.sees({hanging(0.45f)});
  const std::vector<Xyz> points(40 * 30, Xyz{nan, nan, nan});
  std::vector<Xyz> half = points;
  for (std::size_t i = 20 * 40; i < half.size(); ++i) half[i] = {1.0f, 0.5f, 2.0f};
  CloudView small = view_of(half);
  small.width = 40, small.height = 30, small.row_step = 40 * sizeof(Xyz);
  EXPECT_EQ(robot.sees(small).cause, Cause::NearLoss);
}

}  // namespace
}  // namespace safety_control_cloud
