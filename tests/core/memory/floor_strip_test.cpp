// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/floor_strip.hpp"

#include <gtest/gtest.h>

#include <random>

#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

TEST(FloorStrip, RobotStandsForAPostThatSlidesInFromTheSideTooNearToBeSeen) {
  Robot robot;
  robot.sees(Scene());
  for (const float x : {0.15f, 0.1f, 0.0f, -0.05f}) {
    const Decision decision = robot.sees({post(0.35f, x, 0.04f)});
    EXPECT_EQ(decision.cause, Cause::NearLoss) << x;
    EXPECT_EQ(decision.speed, 0.0) << x;
  }
  EXPECT_EQ(robot.sees(Scene()).speed, 0.2) << "it has gone: the floor is seen again";
}

TEST(FloorStrip, RobotStandsForAPostThatWasTooNearToBeSeenFromTheStart) {
  for (const float z : {0.2f, 0.3f, 0.38f}) {
    Robot robot;
    const Decision decision = robot.sees({post(z, 0.0f, 0.03f)});
    EXPECT_EQ(decision.cause, Cause::NearLoss) << z;
    EXPECT_EQ(decision.speed, 0.0) << z;
  }
}

Scene with_borders(std::size_t left, std::size_t right) {
  Scene scene;
  for (std::size_t row = 0; row < Scene::height; ++row) {
    for (std::size_t i = 0; i < left; ++i) scene.set(row, i, NAN);
    for (std::size_t i = 1; i <= right; ++i) scene.set(row, Scene::width - i, NAN);
  }
  return scene;
}

TEST(FloorStrip, ABorderOfThePictureThatNeverReturnsHidesNothing) {
  Robot robot;
  EXPECT_EQ(robot.sees(with_borders(20, 20)).speed, 0.2);
}

TEST(FloorStrip, RobotStandsForAPostAtTheBorderOfThePictureThatWasTooNearToBeSeenFromTheStart) {
  EXPECT_EQ(Robot().sees(with_borders(21, 0)).speed, 0.0) << "no camera has a border as wide as this";
  EXPECT_EQ(Robot().sees(with_borders(0, 21)).speed, 0.0);
}

TEST(FloorStrip, ABorderThatWidensAsDepthShrinksIsNoLossForEver) {
  const Board wall = {0.9f, -2.0f, 2.0f, -2.0f, floor_y};
  Robot robot;
  robot.sees({wall});
  for (int i = 0; i < 20; ++i) EXPECT_EQ(robot.sees(with_borders(8, 0)).speed, 0.2) << "after " << i;
}

TEST(FloorStrip, StrayReturnsInTheBorderAreNoFloor) {
  Robot robot;
  Scene stray = with_borders(8, 0);
  for (const std::size_t row : {112, 115}) {
    for (std::size_t i = 0; i < 8; ++i) stray.set(row, i, 2.0f);
  }
  robot.sees(stray);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(robot.sees(with_borders(8, 0)).speed, 0.2) << "after " << i;
}

TEST(FloorStrip, RobotStandsForAPostThatSlidIntoTheBorderTooNearToBeSeen) {
  for (const float width : {0.03f, 0.05f}) {
    Robot robot;
    for (int i = 0; i < 5; ++i) robot.sees(Scene());
    EXPECT_EQ(robot.sees({post(0.35f, -0.19f, width)}).speed, 0.0) << width;
    EXPECT_EQ(robot.sees({post(0.35f, 0.19f, width)}).speed, 0.0) << width;
  }
}

TEST(FloorStrip, RobotStandsForAPostThatHidesTheFloorAboveABorderOfRowsThatNeverReturn) {
  for (const std::size_t rows : {1, 2, 3}) {
    Robot robot;
    Scene free, hidden({post(0.35f, 0.0f)});
    free.blank_lowest_rows(rows);
    hidden.blank_lowest_rows(rows);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(robot.sees(free).speed, 0.2) << rows;
    EXPECT_EQ(robot.sees(hidden).speed, 0.0) << rows;
    EXPECT_EQ(robot.sees(free).speed, 0.2) << rows;
  }
}

TEST(FloorStrip, StrayReturnsDoNotUncoverTheFloor) {
  std::mt19937 random(7);
  Robot robot;
  for (int i = 0; i < 3; ++i) robot.sees(Scene());
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(robot.sees(Scene({post(0.3f, 0.0f, 0.1f)}).stray(0.1, random)).speed, 0.0) << i;
  }
}

/// Pitched, the strip is of more rows, or of two alone.
constexpr float pitches[] = {0.0f, -0.05f, 0.01f};

TEST(FloorStrip, RobotDrivesOverAnEmptyFloorOfWhichLowLightShowsOneHalfByChance) {
  for (const float nose_up : pitches) {
    for (const unsigned seed : {1u, 2u, 3u}) {
      std::mt19937 random(seed);
      Robot robot;
      for (int i = 0; i < 300; ++i) {
        ASSERT_GT(robot.sees(Scene({}, nose_up).drop(0.5, random)).speed, 0.0)
            << nose_up << ", seed " << seed << " after " << i;
      }
    }
  }
}

/// As many clouds until the robot stands; it never drives on then, however dark it gets.
int clouds_until_it_stands(Robot& robot, const Scene& hidden, double dropped, double strays, std::mt19937& random) {
  int before = 0;
  for (int i = 0; i < 60; ++i) {
    const bool stands =
        robot.sees(Scene(hidden).drop(i < 30 ? dropped : 0.75, random).stray(strays, random)).speed <= 0;
    if (!stands && before < i) return 1000;
    before += !stands;
  }
  return before;
}

/// Up a ramp, or with a head that looks up: as many of its rows are asked, and all of their pixels.
TEST(FloorStrip, RobotDrivesOverAnEmptyFloorThatIsNotNearAnyMoreInLowLightAndStandsForWhatHidesIt) {
  for (const float nose_up : {0.08f, 0.15f}) {
    for (const double dropped : {0.05, 0.15, 0.3, 0.5}) {
      std::mt19937 random(1);
      Robot robot;
      for (int i = 0; i < 30; ++i) robot.sees(Scene().drop(dropped, random));
      for (int i = 0; i < 200; ++i)
        ASSERT_GT(robot.sees(Scene({}, nose_up).drop(dropped, random)).speed, 0.0) << nose_up << ", " << dropped;
      const Scene hidden({post(0.33f, 0.0f, 0.1f)}, nose_up);
      EXPECT_LT(clouds_until_it_stands(robot, hidden, dropped, 0.0, random), 10) << nose_up << ", " << dropped;
    }
  }
}

TEST(FloorStrip, RobotStandsForWhatSlidesInTooNearToBeSeenThoughLowLightBlanksTheFloorByChance) {
  for (const float nose_up : {0.0f, 0.01f}) {
    for (const float width : {0.025f, 0.1f}) {
      const Scene hidden({post(0.33f, 0.03f, width)}, nose_up);
      for (const double dropped : {0.0, 0.3, 0.5}) {
        for (const double strays : {0.0, 0.001, 0.1}) {
          std::mt19937 random(7);
          Robot robot;
          for (int i = 0; i < 12; ++i) robot.sees(Scene({}, nose_up).drop(dropped, random).stray(strays, random));
          const int clouds = clouds_until_it_stands(robot, hidden, dropped, strays, random);
          EXPECT_LT(clouds, dropped > 0.0 ? 10 : 1) << nose_up << ", " << width << ", " << dropped << ", " << strays;
        }
      }
    }
  }
}

TEST(FloorStrip, RobotStandsForAPostThatWasTooNearToBeSeenFromTheStartInLowLight) {
  for (const double dropped : {0.3, 0.5}) {
    std::mt19937 random(7);
    Robot robot;
    EXPECT_LT(clouds_until_it_stands(robot, Scene({post(0.33f, 0.0f, 0.025f)}), dropped, 0.0, random), 10) << dropped;
  }
}

/// It is not taken for darkness.
TEST(FloorStrip, RobotStandsAtOnceForABoardThatHidesAllOfTheFloor) {
  for (const double strays : {0.0, 0.1}) {
    std::mt19937 random(7);
    Robot robot;
    const Board wall = {2.0f, -3.0f, 3.0f, -3.0f, floor_y};
    for (int i = 0; i < 20; ++i) robot.sees({wall});
    const Scene hidden({wall, {0.3f, -1.0f, 1.0f, 0.0f, floor_y}});
    EXPECT_EQ(clouds_until_it_stands(robot, hidden, 0.0, strays, random), 0) << strays;
  }
}

TEST(FloorStrip, RobotStandsForAThinPostThatPassesThroughAPictureInLowLightWhileItTurns) {
  for (const double dropped : {0.3, 0.5}) {
    std::mt19937 random(7);
    Robot robot;
    for (int i = 0; i < 12; ++i) robot.sees(Scene().drop(dropped, random));
    bool stands = false;
    for (float x = 0.18f; x > -0.18f && !stands; x -= 0.018f)
      stands = robot.sees(Scene({post(0.35f, x, 0.025f)}).drop(dropped, random)).speed == 0.0;
    EXPECT_TRUE(stands) << dropped;
  }
}

TEST(FloorStrip, RobotDrivesOnWithinHalfASecondOnceAPostIsTakenAwayInLowLight) {
  for (const double dropped : {0.3, 0.5}) {
    std::mt19937 random(7);
    Robot robot;
    for (int i = 0; i < 20; ++i) robot.sees(Scene().drop(dropped, random));
    for (int i = 0; i < 60; ++i) robot.sees(Scene({post(0.33f, 0.0f, 0.05f)}).drop(dropped, random));
    for (int i = 0; i < 10; ++i) robot.sees(Scene().drop(dropped, random));
    for (int i = 0; i < 60; ++i) EXPECT_GT(robot.sees(Scene().drop(dropped, random)).speed, 0.0) << dropped;
  }
}

}  // namespace
}  // namespace safety_control_cloud
