// SPDX-License-Identifier: BSD-3-Clause
// What comes near while most of the view returns nothing.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

using Boards = std::vector<Board>;

const Board wall = {4.0f, -9.0f, 9.0f, -9.0f, 9.0f};
const Board person = {0.3f, -0.4f, 0.14f, -1.0f, floor_y};  ///< who hides all but the right of the picture

Board board(float z) { return {z, 0.1f, 0.24f, -0.1f, 0.1f}; }

Boards with(const Boards& behind, const Boards& more) {
  Boards all = behind;
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// Of clouds that are organised, or not.
class WhileBlind : public ::testing::TestWithParam<bool> {
 protected:
  Decision sees(const Scene& scene) {
    if (GetParam()) return robot_.sees(scene);
    const auto points = scene.returns();
    return robot_.sees(view_of(points));
  }
  Decision sees(const Boards& boards, int clouds = 1) {
    Decision decision;
    for (int i = 0; i < clouds; ++i) decision = sees(Scene(boards));
    return decision;
  }

  Robot robot_;
};

INSTANTIATE_TEST_SUITE_P(OfEitherKind, WhileBlind, ::testing::Bool());

TEST_P(WhileBlind, WhatCameTooNearIsKnownOnceThatIsOver) {
  for (const Boards& behind : {Boards{wall}, Boards{}}) {
    const bool is_too_empty_to_be_blind = behind.empty() && !GetParam();
    if (is_too_empty_to_be_blind) continue;
    robot_ = Robot();
    sees(behind, 20);
    EXPECT_EQ(sees(with(behind, {person}), 3).cause, Cause::Blind);
    for (float z = 0.6f; z > 0.41f; z -= 0.03f)
      EXPECT_EQ(sees(with(behind, {person, board(z)})).cause, Cause::Blind) << z;
    EXPECT_EQ(sees(with(behind, {person, board(0.36f)}), 5).cause, Cause::Blind);
    const Decision decision = sees(with(behind, {board(0.36f)}), 40);
    EXPECT_EQ(decision.cause, Cause::NearLoss) << behind.size();
    EXPECT_EQ(decision.speed, 0.0);
  }
}

TEST_P(WhileBlind, NothingIsKnownThatHasGoneOnceThatIsOver) {
  const Boards behind{wall};
  sees(behind, 20);
  sees(with(behind, {person}), 3);
  for (float z = 0.6f; z > 0.41f; z -= 0.03f) sees(with(behind, {person, board(z)}));
  for (float z = 0.42f; z < 0.8f; z += 0.03f) sees(with(behind, {person, board(z)}));
  EXPECT_EQ(sees(behind, 5).speed, 0.2);
}

/// Whoever covers the camera by hand has no part in what stands before it.
TEST_P(WhileBlind, RobotDrivesAsBeforeOnceTheCameraIsUncovered) {
  for (const float z : {0.45f, 0.6f, 0.9f, 1.2f}) {
    robot_ = Robot();
    const Boards before{wall, board(z)};
    const double speed = sees(before, 20).speed;
    for (int times = 0; times < 3; ++times) {
      EXPECT_EQ(sees({{0.1f, -9.0f, 9.0f, -9.0f, 9.0f}}, 20).cause, Cause::Blind);
      EXPECT_EQ(sees(before, 3).speed, speed) << z;
    }
    EXPECT_EQ(sees({wall}, 3).speed, 0.2) << z;
  }
}

TEST_P(WhileBlind, WhatIsLostStaysThoughAFewStraysAreSeenBehindIt) {
  std::mt19937 random(7);
  sees({wall}, 20);
  for (float z = 0.6f; z > 0.41f; z -= 0.03f) sees({wall, board(z)});
  ASSERT_EQ(sees({wall, board(0.36f)}, 3).cause, Cause::NearLoss);
  Scene covered({wall});
  covered.drop(0.93, random);
  for (int i = 0; i < 40; ++i) EXPECT_EQ(sees(covered).cause, Cause::Blind);
  EXPECT_EQ(sees({wall, board(0.36f)}, 20).cause, Cause::NearLoss);
}

}  // namespace
}  // namespace safety_control_cloud
