// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/backdrop.hpp"

#include <gtest/gtest.h>

#include <random>

#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

const Board wall = {2.5f, -9.0f, 9.0f, -9.0f, floor_y};

const std::vector<Backdrop::Part> everywhere = {{-1e6, 1e6, -1e6, 1e6}};

/// Places that a picture hides of what others before it have shown.
std::size_t hidden(const Scene& picture, const Scene& before = Scene({wall})) {
  Backdrop backdrop;
  for (int i = 0; i < 40; ++i) backdrop.note(Pixels(before.view(), 0.0f), CameraPose{}, {});
  return backdrop.hidden_in(Pixels(picture.view(), 0.0f)).size();
}

/// Of the wall nothing returns in these columns.
Scene with_hole(std::size_t from, std::size_t to, const std::vector<Board>& boards = {wall}) {
  Scene scene(boards);
  for (std::size_t row = 20; row < 60; ++row)
    for (std::size_t column = from; column < to; ++column) scene.set(row, column, nan);
  return scene;
}

TEST(Backdrop, HasAHoleWhereItWasSeen) {
  EXPECT_EQ(hidden(Scene({wall})), 0u);
  EXPECT_GT(hidden(with_hole(70, 90)), 50u);
}

TEST(Backdrop, HasAHoleThatReachesThePicturesBorder) { EXPECT_GT(hidden(with_hole(0, 20)), 50u); }

TEST(Backdrop, HasNoHoleWhereNothingEverReturned) {
  EXPECT_EQ(hidden(with_hole(70, 90), with_hole(70, 90)), 0u);
  EXPECT_EQ(hidden(with_hole(71, 91), with_hole(70, 90)), 0u) << "the robot has rolled on a little";
}

TEST(Backdrop, HasNoHoleInTheShadowOfWhatIsSeenBesideIt) {
  const Board post = {1.2f, 0.09f, 0.3f, -9.0f, floor_y};
  EXPECT_EQ(hidden(with_hole(78, 90, {post, wall})), 0u);
}

TEST(Backdrop, HasNoHoleWhereACoatCameNearAndWentAway) {
  const Board corner = {2.5f, -9.0f, -0.5f, -9.0f, floor_y};
  Backdrop backdrop;
  for (float z = 2.4f; z > 0.5f; z -= 0.03f) {
    const Scene scene({{z, -0.2f, 0.2f, -9.0f, 0.05f}, corner});
    backdrop.note(Pixels(scene.view(), 0.0f), CameraPose{}, {});
  }
  EXPECT_EQ(backdrop.hidden_in(Pixels(Scene({corner}).view(), 0.0f)).size(), 0u);
}

TEST(Backdrop, HasAHoleForLongOnlyWhereSomethingIsLost) {
  const Scene darkened = with_hole(70, 90);
  const auto hidden_for = [&](int pictures, const Backdrop::Part& lost) {
    Backdrop backdrop;
    for (int i = 0; i < 40; ++i) backdrop.note(Pixels(Scene({wall}).view(), 0.0f), CameraPose{}, {});
    for (int i = 0; i < pictures; ++i) backdrop.note(Pixels(darkened.view(), 0.0f), CameraPose{}, {lost});
    return backdrop.hidden_in(Pixels(darkened.view(), 0.0f)).size();
  };
  const Backdrop::Part there{0, 119, 65, 95}, beside{0, 119, 20, 50};
  EXPECT_GT(hidden_for(200, there), 50u);
  EXPECT_GT(hidden_for(8, beside), 50u) << "it may have come there from where it was lost";
  EXPECT_EQ(hidden_for(50, beside), 0u);
}

TEST(Backdrop, HasNoHoleWhereSomebodyHasStoodForAWhileBeforeNothing) {
  Backdrop backdrop;
  for (int i = 0; i < 200; ++i) backdrop.note(Pixels(with_hole(70, 90).view(), 0.0f), CameraPose{}, {});
  const Board coat = {1.2f, -0.08f, 0.08f, -0.33f, -0.01f};
  for (int i = 0; i < 60; ++i) backdrop.note(Pixels(with_hole(0, 0, {coat, wall}).view(), 0.0f), CameraPose{}, {});
  EXPECT_EQ(backdrop.hidden_in(Pixels(with_hole(70, 90).view(), 0.0f)).size(), 0u);
}

TEST(Backdrop, HasNoHolesByChance) {
  std::mt19937 random(3);
  for (const double share : {0.1, 0.3, 0.5, 0.7}) {
    Backdrop backdrop;
    const auto seen = [&] { return Scene({wall}).drop(share, random); };
    for (int i = 0; i < 100; ++i) {
      const Scene scene = seen();
      backdrop.note(Pixels(scene.view(), 0.0f), CameraPose{}, i > 50 ? everywhere : std::vector<Backdrop::Part>{});
      EXPECT_LT(backdrop.hidden_in(Pixels(scene.view(), 0.0f)).size(), 4u) << share << ", " << i;
    }
  }
}

Board hanging(float z, float x, float width) { return {z, x, x + width, -0.15f, 0.05f}; }

/// Comes nearer than it can be seen.
Decision loses(Robot& robot, float x, float width, const Board& behind = wall) {
  Decision decision;
  for (int i = 0; i < 20; ++i) decision = robot.sees({behind});
  for (float z = 1.0f; z > 0.36f; z -= 0.03f) decision = robot.sees({hanging(z, x, width), behind});
  return decision;
}

int clouds_until_it_drives(Robot& robot, const Scene& scene) {
  int clouds = 0;
  while (clouds < 100 && robot.sees(scene).speed < 0.2) ++clouds;
  return clouds;
}

TEST(Backdrop, WhatSwingsTowardTheMiddleTooNearToBeSeenIsNotForgotten) {
  for (const float width : {0.03f, 0.06f, 0.15f}) {
    for (const float step : {0.002f, 0.01f, 0.05f, 0.2f}) {
      Robot robot;
      ASSERT_EQ(loses(robot, -0.18f, width).speed, 0.0);
      const auto stands_for = [&](float x, int clouds) {
        for (int i = 0; i < clouds; ++i)
          ASSERT_EQ(robot.sees({hanging(0.34f, x, width), wall}).cause, Cause::NearLoss)
              << width << ", " << step << ", " << x;
      };
      const float inmost = 0.12f - width;
      for (float x = -0.18f; x < inmost; x += step) stands_for(x, 1);
      stands_for(inmost, 100);
      for (float x = inmost; x > -0.18f; x -= step) stands_for(x, 1);
      EXPECT_LT(clouds_until_it_drives(robot, Scene({wall})), 10) << "it has been taken away";
    }
  }
}

TEST(Backdrop, WhatHasSwungIsForgottenWhereSomebodyWalksPastOrSomethingNeverReturns) {
  Robot robot;
  loses(robot, -0.18f, 0.06f);
  for (int i = 0; i < 10; ++i) robot.sees({hanging(0.34f, -0.05f, 0.06f), wall});
  for (float x = -1.5f; x < 1.5f; x += 0.05f) robot.sees({{1.5f, x, x + 0.4f, -9.0f, floor_y}, wall});
  EXPECT_LT(clouds_until_it_drives(robot, Scene({wall})), 10);

  robot = Robot();
  for (int i = 0; i < 20; ++i) robot.sees(with_hole(20, 50));
  for (float z = 1.0f; z > 0.36f; z -= 0.03f) robot.sees(with_hole(20, 50, {hanging(z, 0.0f, 0.06f), wall}));
  for (float x = 0.0f; x < 0.1f; x += 0.02f) robot.sees(with_hole(20, 50, {hanging(0.34f, x, 0.06f), wall}));
  EXPECT_LT(clouds_until_it_drives(robot, with_hole(20, 50)), 10);
}

TEST(Backdrop, WhatHasSwungAndIsSeenAgainIsLostWhereItWasSeenLast) {
  const auto before_black = [](float z) { return with_hole(20, 60, {hanging(z, -0.15f, 0.06f), wall}); };
  Robot robot;
  for (int i = 0; i < 40; ++i) robot.sees(with_hole(20, 60));
  for (float z = 1.0f; z > 0.36f; z -= 0.03f) robot.sees(with_hole(20, 60, {hanging(z, 0.1f, 0.06f), wall}));
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(robot.sees(with_hole(20, 60, {hanging(0.34f, 0.0f, 0.06f), wall})).cause, Cause::NearLoss) << i;
  }
  for (int i = 0; i < 10; ++i) robot.sees(before_black(0.5f));
  for (int i = 0; i < 100; ++i) ASSERT_EQ(robot.sees(before_black(0.36f)).speed, 0.0) << i;
}

TEST(Backdrop, WhatHasSwungIsForgottenAfterItsTimeout) {
  Settings settings;
  settings.near_loss.timeout = 1.0;
  Robot robot(settings);
  loses(robot, -0.18f, 0.06f);
  for (int i = 0; i < 10; ++i) ASSERT_EQ(robot.sees({hanging(0.34f, -0.05f, 0.06f), wall}).speed, 0.0) << i;
  for (int i = 0; i < 20; ++i) robot.sees({hanging(0.34f, -0.05f, 0.06f), wall});
  EXPECT_EQ(robot.sees({hanging(0.34f, -0.05f, 0.06f), wall}).speed, 0.2);
}

}  // namespace
}  // namespace safety_control_cloud
