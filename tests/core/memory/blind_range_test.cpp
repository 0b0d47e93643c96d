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

}  // namespace
}  // namespace safety_control_cloud
