// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "../../../safety_control_cloud/core/memory/things_memory.hpp"
#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

const Board wall = {2.0f, -3.0f, 3.0f, -3.0f, floor_y};

constexpr float beyond = 1.1f;  ///< [m] strays that are nearer stop the robot whatever it remembers

Board board_at(float z) { return {z, -0.2f, 0.2f, -0.2f, 0.05f}; }

/// How the same picture reaches the robot.
class Sent : public testing::TestWithParam<bool> {
 protected:
  Decision sees(const Scene& scene) {
    if (GetParam()) return robot.sees(scene);
    const auto points = scene.returns();
    return robot.sees(view_of(points));
  }
  Robot robot;
};
INSTANTIATE_TEST_SUITE_P(As, Sent, testing::Values(true, false),
                         [](const auto& info) { return info.param ? "Picture" : "Points"; });

TEST_P(Sent, StrayReturnsEraseNoObstacleHoweverLongTheyCome) {
  for (const double share : {0.001, 0.01, 0.1}) {
    std::mt19937 random(7);
    robot = Robot();
    for (const float z : {0.7f, 0.6f, 0.5f, 0.42f}) sees(Scene({board_at(z), wall}));
    for (int i = 0; i < 400; ++i) {
      const Scene scene = Scene({board_at(0.35f), wall}).stray(share, random, beyond);
      ASSERT_EQ(sees(scene).cause, Cause::NearLoss) << share << " after " << i;
    }
    int clouds = 0;
    while (clouds < 30 && sees(Scene({wall})).speed < 0.2) ++clouds;
    EXPECT_LT(clouds, 15) << "it has been taken away";
  }
}

/// Of a rail of so few rows no pixel has others on all sides.
TEST_P(Sent, RailThatTouchedALegIsNotForgottenWithIt) {
  for (const float thickness : {0.025f, 0.03f, 0.04f}) {
    robot = Robot();
    const Board behind = {4.5f, -9.0f, 9.0f, -9.0f, floor_y};
    const auto leg = [](float aside) { return Board{0.42f, 0.18f + aside, 0.28f + aside, -1.0f, floor_y}; };
    const auto rail = [&](float z) { return Board{z, -0.3f, 0.18f, 0.02f, 0.02f + thickness}; };
    const auto pass = [&](const std::vector<Board>& boards, int clouds) {
      Decision decision;
      for (int i = 0; i < clouds; ++i) decision = sees(Scene(boards));
      return decision;
    };
    pass({leg(0.0f), behind}, 5);
    for (const float z : {0.6f, 0.5f, 0.45f, 0.42f}) pass({leg(0.0f), rail(z), behind}, 3);
    pass({leg(0.0f), rail(0.38f), behind}, 6);
    for (const float aside : {0.13f, 0.26f, 0.4f}) pass({leg(aside), rail(0.38f), behind}, 1);
    EXPECT_EQ(pass({rail(0.38f), behind}, 40).cause, Cause::NearLoss) << thickness;
    EXPECT_EQ(pass({behind}, 10).speed, 0.2) << thickness << ": both have gone";
  }
}

TEST_P(Sent, StrayReturnsInAHallDeeperThanTheSensorEraseNoObstacle) {
  std::mt19937 random(7);
  for (const float z : {0.7f, 0.6f, 0.5f, 0.42f}) sees(Scene({board_at(z)}));
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(sees(Scene({board_at(0.35f)}).stray(0.1, random, beyond)).cause, Cause::NearLoss) << i;
  }
}

/// Holes in it say nothing then, since it was full of them itself.
TEST_P(Sent, StrayReturnsEraseNothingSmallOfWhichFewPixelsReturned) {
  for (const double dropped : {0.4, 0.6}) {
    for (const float width : {0.05f, 0.1f}) {
      std::mt19937 random(7);
      robot = Robot();
      const auto small = [width](float z) { return Board{z, -width / 2, width / 2, -0.01f, 0.05f}; };
      for (float z = 0.8f; z > 0.4f; z -= 0.01f) sees(Scene({small(z), wall}).drop(dropped, random));
      for (int i = 0; i < 200; ++i) {
        const Scene scene = Scene({small(0.33f), wall}).drop(dropped, random).stray(0.1, random, beyond);
        ASSERT_EQ(sees(scene).cause, Cause::NearLoss) << dropped << ", " << width << " after " << i;
      }
    }
  }
}

TEST_P(Sent, ThinRailBeforeAWallStaysWhereverItHangs) {
  for (float y = -0.14f; y < 0.15f; y += 0.0151f) {
    robot = Robot();
    const auto rail = [y](float z) { return Board{z, -0.25f, 0.25f, y, y + 0.006f}; };
    float z = 0.8f;
    for (; z > 0.4f; z -= 0.01f) sees(Scene({rail(z), {z + 1.0f, -3.0f, 3.0f, -3.0f, floor_y}}));
    for (int i = 0; i < 60; ++i) {
      const float braking = std::max(0.35f, z - 0.01f * static_cast<float>(i));
      ASSERT_EQ(sees(Scene({rail(braking), {braking + 1.0f, -3.0f, 3.0f, -3.0f, floor_y}})).speed, 0.0)
          << y << " after " << i;
    }
  }
}

TEST_P(Sent, ALegThatGoesDoesNotForgiveTheBagAboveIt) {
  const Board leg = {0.6f, -0.06f, 0.06f, -1.0f, floor_y};
  const auto bag = [](float z) { return Board{z, -0.12f, 0.12f, -0.25f, 0.02f}; };
  for (const float z : {0.45f, 0.42f}) sees(Scene({leg, bag(z)}));
  EXPECT_EQ(sees(Scene({leg, bag(0.3f)})).speed, 0.0);
  for (int i = 0; i < 60; ++i) ASSERT_EQ(sees(Scene({bag(0.3f)})).speed, 0.0) << i;
}

/// It hangs before a box and is a small part of what is seen.
TEST_P(Sent, WhatWentOutOfSightBeforeTheRestOfAThingDoesNotGoWithThatRest) {
  const auto knob = [](float z) { return Board{z, -0.03f, 0.03f, -0.03f, 0.02f}; };
  const auto box = [](float z) { return Board{z + 0.03f, -0.12f, 0.12f, -0.1f, 0.1f}; };
  const Board wall = {3.0f, -9.0f, 9.0f, -9.0f, floor_y};
  for (const float step : {0.04f, 0.02f, 0.005f}) {
    robot = Robot();
    float z = 0.6f;
    for (; z > 0.385f; z -= step) sees(Scene({knob(z), box(z), wall}));
    for (int i = 0; i < 10; ++i) sees(Scene({knob(z), box(z), wall}));
    for (float behind = z; behind < 1.0f; behind += 0.05f) sees(Scene({knob(z), box(behind), wall}));
    for (int i = 0; i < 60; ++i) ASSERT_EQ(sees(Scene({knob(z), wall})).speed, 0.0) << step << ", " << i;
  }
}

TEST_P(Sent, ALostThingIsTrustedNowhereElseBecauseSomethingLargerIsNear) {
  const Board thing = {0.6f, -0.25f, -0.15f, -0.2f, 0.1f}, larger = {0.7f, -0.05f, 0.25f, -0.2f, 0.1f};
  for (int i = 0; i < 3; ++i) sees(Scene({thing, larger}));
  Board nearer = thing;
  nearer.z = 0.35f;
  nearer.x_min = -0.145f, nearer.x_max = -0.09f;
  for (int i = 0; i < 20; ++i) {
    robot.waits(0.3);
    ASSERT_EQ(sees(Scene({nearer, larger})).speed, 0.0) << i;
  }
}

TEST_P(Sent, WhatHungInAHallAndIsSeenToMoveAwayIsNotLost) {
  robot.sees(Scene());
  for (float z = 0.6f; z < 1.5f; z += 0.03f) EXPECT_LE(sees(Scene({board_at(z)})).speed, z < 0.97f ? 0.1 : 0.2) << z;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(sees(Scene({board_at(1.6f)})).speed, 0.2);
}

TEST_P(Sent, ChangeOfTheCorridorJudgesWhatIsLostAgain) {
  const Board aside = {0.45f, 0.15f, 0.22f, -0.2f, 0.1f};
  for (int i = 0; i < 3; ++i) sees(Scene({aside}));
  Board blind = aside;
  blind.z = 0.36f, blind.x_min = 0.12f, blind.x_max = 0.18f;
  EXPECT_EQ(sees(Scene({blind})).speed, 0.0);
  Settings narrow;
  narrow.corridor.x_max = 0.1f;
  robot.control().adopt(narrow);
  EXPECT_EQ(sees(Scene({blind})).speed, 0.2) << "it lies beside the corridor now";
  robot.control().adopt(Settings{});
  EXPECT_EQ(sees(Scene({blind})).speed, 0.0) << "and in it again";
  Settings farther;
  farther.near_loss.distance = 0.76;
  robot.control().adopt(farther);
  EXPECT_EQ(sees(Scene({blind})).speed, 0.0) << "a change of the distance forgets nothing";
}

/// Of a picture, since what is left of a cloud that is not organised is told from its usual rays.
TEST(Things, AreSeenToGoWithin1_5SecondsThoughThreePixelsInTenReturnNothing) {
  for (const float width : {0.1f, 0.3f, 0.6f}) {
    for (unsigned seed = 0; seed < 4; ++seed) {
      std::mt19937 random(seed);
      Robot robot;
      const auto sees = [&](const std::vector<Board>& boards) { return robot.sees(Scene(boards).drop(0.3, random)); };
      const auto hanging = [&](float z) { return Board{z, -width / 2, width / 2, -0.15f, 0.1f}; };
      for (int i = 0; i < 20; ++i) sees({wall});
      for (float z = 1.0f; z > 0.36f; z -= 0.03f) sees({hanging(z), wall});
      for (int i = 0; i < 100; ++i)
        ASSERT_EQ(sees({hanging(0.34f), wall}).cause, Cause::NearLoss) << width << ", " << i;
      int clouds = 0;
      while (clouds < 100 && sees({wall}).speed < 0.2) ++clouds;
      EXPECT_LE(clouds, 30) << width << ", " << seed;
    }
  }
}

}  // namespace
}  // namespace safety_control_cloud
