// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "../../../safety_control_cloud/core/memory/evidence.hpp"
#include "../../../safety_control_cloud/core/memory/raster.hpp"
#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

TEST(Unorganised, UnorganisedCloudKeepsItsNearestUntilSomethingIsSeenBehindIt) {
  Robot robot;
  const std::vector<Xyz> near = {{0.05f, 0.0f, 0.45f}, {0.0f, 1.0f, 3.0f}};
  const std::vector<Xyz> lost = {{0.9f, 0.0f, 3.0f}, {0.0f, 1.0f, 3.0f}};
  const std::vector<Xyz> behind = {{0.34f, 0.0f, 3.06f}, {0.0f, 1.0f, 3.0f}};
  EXPECT_EQ(robot.sees(view_of(near)).cause, Cause::Seen);
  const Decision decision = robot.sees(view_of(lost));
  EXPECT_EQ(decision.cause, Cause::NearLoss);
  EXPECT_FLOAT_EQ(static_cast<float>(decision.nearest->distance()), 0.45f);
  EXPECT_EQ(decision.speed, 0.0);
  EXPECT_EQ(robot.sees(view_of(behind)).speed, 0.2);
}

TEST(Unorganised, AnotherOneFartherAwayDoesNotTakeItsPlace) {
  Robot robot;
  const std::vector<Xyz> both = {{0.0f, 0.0f, 0.45f}, {0.2f, 0.0f, 0.7f}, {0.0f, 1.0f, 3.0f}};
  const std::vector<Xyz> farther = {{nan, nan, nan}, {0.2f, 0.0f, 0.7f}, {0.0f, 1.0f, 3.0f}};
  const std::vector<Xyz> behind = {{0.0f, 0.0f, 3.0f}, {0.2f, 0.0f, 0.7f}, {0.0f, 1.0f, 3.0f}};
  robot.sees(view_of(both));
  EXPECT_EQ(robot.sees(view_of(farther)).cause, Cause::NearLoss);
  EXPECT_EQ(robot.sees(view_of(farther)).speed, 0.0);
  EXPECT_EQ(robot.sees(view_of(behind)).speed, 0.1);
}

TEST(Unorganised, BehindIsAsTheCameraLooksWhereverTheCorridorLies) {
  Placement on_the_floor;
  on_the_floor.rows[1][3] = -0.3f;
  Settings settings;
  settings.target_frame = "base_footprint";
  settings.frame_corridor.top = 0.5;
  Robot robot(settings, on_the_floor);
  const std::vector<Xyz> near = {{0.0f, 0.2f, 0.45f}, {0.0f, -1.0f, 3.0f}};
  const std::vector<Xyz> above = {{0.0f, -0.367f, 3.0f}, {0.0f, -1.0f, 3.0f}};  // as from the floor it would be behind
  const std::vector<Xyz> behind = {{0.0f, 0.444f, 1.0f}, {0.0f, -1.0f, 3.0f}};
  robot.sees(view_of(near));
  EXPECT_EQ(robot.sees(view_of(above)).cause, Cause::NearLoss);
  EXPECT_EQ(robot.sees(view_of(behind)).speed, 0.2);
}

/// Between points that lie far apart nothing returns wherever they move to.
TEST(Unorganised, WallOfFewPointsThatIsSeenToMoveAwayIsNotLost) {
  Robot robot;
  for (const float z : {0.5f, 0.8f, 1.1f}) {
    std::vector<Xyz> wall;
    for (int i = 0; i < 13 * 11; ++i) {
      wall.push_back({-0.6f + 0.1f * static_cast<float>(i % 13), -0.5f + 0.1f * static_cast<float>(i / 13), z});
    }
    const Decision decision = robot.sees(view_of(wall));
    EXPECT_EQ(decision.cause, Cause::Seen) << z;
    EXPECT_EQ(decision.speed, z > 1.0f ? 0.2 : z > 0.6f ? 0.1 : 0.0) << z;
  }
}

/// As far apart as before in metres, so that the cells of the raster grow with each step.
TEST(Unorganised, WallOfFewPointsThatCameNearAndMovesAwayIsNotLost) {
  Robot robot;
  double speed = 0.0;
  for (const float z : {1.5f, 1.0f, 0.75f, 0.5f, 0.4f, 0.51f, 1.01f}) {
    std::vector<Xyz> wall;
    for (int i = 0; i < 13 * 11; ++i) {
      wall.push_back({-0.6f + 0.1f * static_cast<float>(i % 13), -0.5f + 0.1f * static_cast<float>(i / 13), z});
    }
    const Decision decision = robot.sees(view_of(wall));
    EXPECT_EQ(decision.cause, Cause::Seen) << z << ": " << decision.reason;
    speed = decision.speed;
  }
  EXPECT_EQ(speed, 0.2);
}

/// What is thinner than two cells of the raster leaves no hole in it.
TEST(Unorganised, ThinThingThatIsTooNearLiesBetweenTheRays) {
  const Board wall = {2.0f, -4.0f, 4.0f, -3.0f, floor_y};
  struct Thin {
    float width, x, height, y;  ///< and its lower and left edge
  };
  std::vector<Thin> all;
  for (const float at : {-0.094f, -0.034f, 0.0261f, 0.0412f, 0.1318f}) {
    for (const float thickness : {0.006f, 0.012f}) {
      all.push_back({thickness, at, 0.2f, -0.1f});
      all.push_back({thickness, at, 0.5f, -0.25f});
      all.push_back({0.5f, -0.25f, thickness, at});
    }
  }
  for (const Thin& thin : all) {
    const auto at = [&](float z) { return Board{z, thin.x, thin.x + thin.width, thin.y, thin.y + thin.height}; };
    Robot robot;
    const auto sees = [&](const std::vector<Board>& boards) {
      const auto points = Scene(boards).returns();
      return robot.sees(view_of(points));
    };
    float z = 0.8f;
    for (; z > 0.4f; z -= 0.01f) sees({at(z), wall});
    for (int i = 0; i < 20; ++i, z = std::max(0.34f, z - 0.01f)) {
      ASSERT_EQ(sees({at(z), wall}).speed, 0.0) << thin.x << ", " << thin.y << ", " << thin.width << " after " << i;
    }
    Decision decision;
    for (int i = 0; i < 30; ++i) decision = sees({wall});
    EXPECT_EQ(decision.speed, 0.2) << thin.x << ", " << thin.y << ", " << thin.width << ": it has been taken away";
  }
}

TEST(Unorganised, CloudOfOneColumnIsNoPictureAndKeepsItsNearestToo) {
  const auto column = [](const std::vector<Xyz>& points) {
    CloudView view = view_of(points);
    view.width = 1, view.height = points.size(), view.row_step = sizeof(Xyz);
    return view;
  };
  Robot robot;
  const std::vector<Xyz> near = {{0.0f, 0.0f, 0.6f}, {0.0f, 0.01f, 0.6f}, {0.0f, 1.0f, 3.0f}};
  const std::vector<Xyz> lost = {{nan, nan, nan}, {nan, nan, nan}, {0.0f, 1.0f, 3.0f}};
  robot.sees(column(near));
  EXPECT_EQ(robot.sees(column(lost)).cause, Cause::NearLoss);
}

TEST(Unorganised, PictureTooTallToCountStillKeepsItsNearest) {
  std::vector<Xyz> points(2 * 65536, Xyz{0.0f, 0.0f, 0.6f});
  CloudView tall = view_of(points);
  tall.width = 2, tall.height = 65536, tall.row_step = 2 * sizeof(Xyz);
  Robot robot;
  robot.sees(tall);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = i % 2 ? Xyz{nan, nan, nan} : Xyz{0.9f, 0.0f, 3.0f};
  EXPECT_EQ(robot.sees(tall).cause, Cause::NearLoss);
}

TEST(Unorganised, UnorganisedObstacleThatWasTooCloseToMeasureDoesNotStopTheRobotForEver) {
  Robot robot;
  const std::vector<Xyz> too_close = {{nan, nan, -inf}, {0.0f, 1.0f, 3.0f}};
  const std::vector<Xyz> free = {{0.9f, 0.0f, 3.0f}, {0.0f, 1.0f, 3.0f}};
  EXPECT_EQ(robot.sees(view_of(too_close)).speed, 0.0);
  EXPECT_EQ(robot.sees(view_of(free)).speed, 0.2);
}

TEST(Unorganised, UnorganisedObstacleThatCameTooCloseToMeasureIsStillThere) {
  Robot robot;
  const std::vector<Xyz> near = {{0.0f, 0.0f, 0.6f}, {0.0f, 1.0f, 3.0f}};
  const std::vector<Xyz> too_close = {{nan, nan, -inf}, {0.0f, 1.0f, 3.0f}};
  const std::vector<Xyz> lost = {{nan, nan, nan}, {0.0f, 1.0f, 3.0f}};
  robot.sees(view_of(near));
  robot.sees(view_of(too_close));
  EXPECT_EQ(robot.sees(view_of(lost)).cause, Cause::NearLoss);
}

TEST(Unorganised, UnorganisedObstacleThatRetreatsIsNotLost) {
  Robot robot;
  const std::vector<Xyz> near = {{0.0f, 0.0f, 0.74f}, {0.0f, 1.0f, 3.0f}};
  const std::vector<Xyz> farther = {{0.08f, 0.0f, 0.76f}, {0.0f, 1.0f, 3.0f}};
  robot.sees(view_of(near));
  EXPECT_EQ(robot.sees(view_of(farther)).cause, Cause::Seen);
}

TEST(Unorganised, PointsThatAllLieFarAsideAreAPictureOfNothing) {
  Settings settings;
  settings.min_valid_ratio = 0.0;
  Robot robot(settings);
  robot.sees({{0.45f, -0.2f, 0.2f, -0.2f, 0.05f}});
  const std::vector<Xyz> aside(50, Xyz{10.0f, 0.0f, 1.0f});
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(robot.sees(view_of(aside)).cause, Cause::NearLoss) << "nothing is seen behind it";
}

TEST(Unorganised, TheRasterKnowsWhereTheCameraLooksAndWhatOfItNeverReturns) {
  std::vector<Xyz> points;
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 60; ++column)
      points.push_back({-0.4f + 0.02f * static_cast<float>(column), 0.02f * static_cast<float>(row), 1.0f});
  Raster raster;
  EXPECT_EQ(raster.framing().left, std::size_t{0});
  raster.picture_of(view_of(points), Corridor{}, true);
  const Grid& grid = raster.grid();
  const Framing framing = raster.framing();
  const auto border = [&](float x, float y) { return std::pair(grid.row({x, y, 1.0f}), grid.column({x, y, 1.0f})); };
  EXPECT_EQ(border(-0.4f, 0.0f), std::pair(std::ptrdiff_t(framing.top), std::ptrdiff_t(framing.left)));
  const auto right = std::ptrdiff_t(grid.width - 1 - framing.right),
             bottom = std::ptrdiff_t(grid.height - 1 - framing.bottom);
  EXPECT_EQ(border(0.78f, 0.78f), std::pair(bottom, right));
  EXPECT_NEAR(framing.middle_column, static_cast<double>(grid.column({0.0f, 0.0f, 1.0f})), 1.0);
  EXPECT_NEAR(framing.middle_row, static_cast<double>(grid.row({0.0f, 0.0f, 1.0f})), 1.0);
  EXPECT_GT(framing.top, std::size_t{0}) << "above the horizon nothing returns";
}

/// It hides the near floor, and one stray return in ten pixels shows something there all the same.
TEST(Unorganised, AThinPostStaysBetweenStrayReturns) {
  for (unsigned seed = 0; seed < 16; ++seed) {
    std::mt19937 random(seed);
    Robot robot;
    const float x = seed % 2 == 0 ? 0.16f : -0.15f;
    for (float z = 0.9f; z > 0.33f; z -= 0.025f) {
      const auto points = Scene({post(z, x, 0.02f)}).stray(0.1, random, 1.1f).returns();
      robot.sees(view_of(points));
    }
    for (int i = 0; i < 100; ++i) {
      const auto points = Scene({post(0.33f, x, 0.02f)}).stray(0.1, random, 1.1f).returns();
      ASSERT_EQ(robot.sees(view_of(points)).speed, 0.0) << seed << " after " << i;
    }
  }
}

/// Beyond the outermost rays nothing returns, and few spots lie beside some of them on one way or another.
TEST(Unorganised, WhatLeavesThePictureAndWhatIsTinyDoNotLieBetweenRays) {
  for (const float spacing : {0.0036f, 0.0072f}) {
    std::vector<Xyz> wall;
    for (float y = -0.43f; y < 0.43f; y += spacing)
      for (float x = -0.5755f; x < 0.5755f; x += spacing) wall.push_back({2.2f * x, 2.2f * y, 2.2f});
    Raster raster;
    Pixels picture(raster.picture_of(view_of(wall), Corridor{}, true), 0.0f, &raster.hits());
    picture.frame(raster.framing());
    for (const std::size_t count : {2, 20}) {
      for (float at = -0.56f; at < 0.56f; at += 0.01f) {
        std::vector<Spot> upright(count), lying(count);
        for (std::size_t i = 0; i < count; ++i) {
          const float z = 0.4f + 0.0004f * static_cast<float>(i), along = 0.005f * static_cast<float>(i);
          upright[i].point = {at * z, (along - 0.1f) * z, z};
          lying[i].point = {(along - 0.1f) * z, 0.7f * at * z, z};
        }
        EXPECT_FALSE(may_lie_between_rays(upright, picture)) << spacing << ", " << count << " at " << at;
        EXPECT_FALSE(may_lie_between_rays(lying, picture)) << spacing << ", " << count << " at " << at;
      }
    }
  }
}

}  // namespace
}  // namespace safety_control_cloud
