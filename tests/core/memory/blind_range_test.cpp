// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "../../../safety_control_cloud/core/memory/things_memory.hpp"
#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

Board board_at(float z) { return {z, -0.15f, 0.15f, -0.2f, 0.1f}; }

/// A sensor that returns nothing nearer than this.
Scene seen_from(float blind, const std::vector<Board>& boards) {
  Scene scene(boards);
  scene.blank_nearer_than(blind);
  return scene;
}

TEST(BlindRange, WhatVanishesInMidAirBeyondTheNearDistanceWasNotSeenToGoAway) {
  for (const float blind : {0.8f, 0.9f, 1.0f}) {
    Robot robot;
    for (float z = blind + 0.2f; z > blind; z -= 0.01f) robot.sees(seen_from(blind, {board_at(z)}));
    for (int i = 0; i < 40; ++i) {
      const Decision decision = robot.sees(seen_from(blind, {board_at(blind - 0.01f)}));
      ASSERT_EQ(decision.cause, Cause::NearLoss) << blind << " after " << i;
      ASSERT_EQ(decision.speed, 0.0) << blind << " after " << i;
    }
    const Board wall = {2.0f, -3.0f, 3.0f, -3.0f, floor_y};
    for (int i = 0; i < 3; ++i) robot.sees({wall});
    EXPECT_EQ(robot.sees({wall}).speed, 0.2) << "it has been taken away";
  }
}

TEST(BlindRange, ThatIsKnownKeepsEvenWhatIsSeenOnce) {
  Settings settings;
  settings.near_loss.blind_range = 0.8;
  Robot robot(settings);
  robot.sees(seen_from(0.8f, {board_at(0.84f)}));
  EXPECT_EQ(robot.sees(seen_from(0.8f, {board_at(0.79f)})).speed, 0.0);
}

TEST(BlindRange, IsMeasuredFromTheCameraWhereverTheFrameBegins) {
  Placement camera;
  camera.rows[1][3] = -floor_y;
  camera.rows[2][3] = 0.4f;
  Settings settings;
  settings.target_frame = "base_footprint";
  Robot robot(settings, camera);
  robot.sees({board_at(0.7f)});
  EXPECT_EQ(robot.sees({board_at(0.38f)}).speed, 0.0)
      << "it was seen 1.1 m ahead of the frame, 0.7 m ahead of the camera";
}

TEST(BlindRange, WhoWalksOutOfThePictureHasNotVanished) {
  Robot robot;
  robot.sees(Scene());
  for (float x = -0.2f; x < 0.8f; x += 0.05f) robot.sees({post(0.95f, x, 0.15f)});
  EXPECT_EQ(robot.sees(Scene()).speed, 0.2);
}

/// Something of it is always in view, at the same distance.
TEST(BlindRange, RobotStandsForAWallAcrossTheCorridorThatGoesOnNearerThanTheSensorSees) {
  for (const double blind : {0.5, 0.6}) {
    for (const float slope : {0.6f, 1.0f, 2.0f}) {  // of the wall: how much nearer it comes on its way to the right
      for (const bool is_organised : {true, false}) {
        Settings settings;
        settings.near_loss.blind_range = blind;
        Robot robot(settings);
        double speed = 1.0, stood_at = 0.0;
        for (float nearest = 1.2f; nearest > 0.1f && speed > 0.0; nearest -= 0.01f) {
          std::vector<Board> wall;
          for (float x = -0.5f; x < 0.3f; x += 0.01f) {
            wall.push_back({nearest + slope * (0.3f - x), x, x + 0.011f, -0.3f, floor_y});
          }
          const Scene scene = seen_from(static_cast<float>(blind), wall);
          const auto points = scene.returns();
          speed = is_organised ? robot.sees(scene).speed : robot.sees(view_of(points)).speed;
          stood_at = double{nearest};
        }
        EXPECT_GT(stood_at, blind) << slope << (is_organised ? "" : ", not organised");
        EXPECT_LT(stood_at, blind + 0.1) << slope << (is_organised ? "" : ", not organised");
      }
    }
  }
}

TEST(BlindRange, WhatIsCutOffByItSaysSo) {
  Settings settings;
  settings.near_loss.blind_range = 0.6;
  Robot robot(settings);
  const Decision decision = robot.sees({board_at(0.62f)});
  EXPECT_EQ(decision.zone, Zone::Danger);
  EXPECT_EQ(decision.cause, Cause::Seen);
  EXPECT_EQ(decision.reason, "nearest obstacle at 0.620 m, and nearer than that the camera may be blind for it");
  EXPECT_EQ(Robot(settings).sees({board_at(0.66f)}).zone, Zone::Warning);
  settings.near_loss.distance = 0.0;
  EXPECT_EQ(Robot(settings).sees({board_at(0.62f)}).zone, Zone::Warning)
      << "the memory is off, and blind_range with it";
}

/// What was lost nearer than the blind range and a step may be anywhere nearer.
TEST(BlindRange, APartThatIsLostThereIsDangerThoughMostIsStillSeen) {
  Settings settings;
  settings.near_loss.blind_range = 0.6;
  Robot robot(settings);
  const auto sees = [&](float nearer) {
    const Board part = {nearer, -0.15f, -0.03f, -0.2f, 0.1f}, rest = {0.66f, -0.03f, 0.25f, -0.2f, 0.1f};
    return robot.sees(seen_from(0.6f, {part, rest}));
  };
  for (const float z : {0.65f, 0.64f, 0.63f, 0.62f, 0.61f}) sees(z);
  EXPECT_EQ(sees(0.58f).speed, 0.0);
}

}  // namespace
}  // namespace safety_control_cloud
