// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/low_obstacles.hpp"

#include <gtest/gtest.h>

#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

/// The front of something `height` [m] high that stands on the floor: behind it the floor is seen again.
Board kerb(float z, float height, float width = 0.4f) { return {z, -width / 2, width / 2, floor_y - height, floor_y}; }

/// What lies on the floor from z on, as deep as the camera sees.
Scene with_plateau(float z, float height) {
  std::vector<Board> boards;
  for (float behind = z; behind < 0.9f; behind += 0.005f) boards.push_back(kerb(behind, height));
  return Scene(boards);
}

/// What one cloud alone shows is neither kept nor does it make anything forgotten.
Decision after_two(Robot& robot, const Scene& scene) {
  robot.sees(scene);
  return robot.sees(scene);
}

TEST(LowObstacles, RobotSlowsBeforeAKerbAndStandsWhileItIsStillInSight) {
  for (const float height : {0.05f, 0.085f}) {
    Robot robot;
    for (const float z : {1.2f, 1.0f, 0.8f}) EXPECT_EQ(robot.sees({kerb(z, height)}).speed, 0.2) << height;
    for (const float z : {0.76f, 0.74f, 0.72f}) {
      const Decision decision = robot.sees({kerb(z, height)});
      EXPECT_EQ(decision.cause, Cause::LowObstacle) << height << " at " << z;
      EXPECT_EQ(decision.speed, 0.1) << height << " at " << z;
      EXPECT_NEAR(decision.nearest->distance(), z, 1e-6);
    }
    for (const float z : {0.65f, 0.63f, 0.60f}) {
      const Decision decision = robot.sees({kerb(z, height)});
      EXPECT_EQ(decision.cause, Cause::LowObstacle) << height << " at " << z;
      EXPECT_EQ(decision.speed, 0.0) << height << " at " << z;
    }
    EXPECT_EQ(after_two(robot, Scene()).speed, 0.2) << "the floor before it is seen again";
  }
}

TEST(LowObstacles, RobotSlowsBeforeAStepOfThreeCentimetres) {
  Robot robot;
  EXPECT_EQ(after_two(robot, with_plateau(0.72f, 0.03f)).speed, 0.1);
  EXPECT_EQ(robot.sees(with_plateau(0.64f, 0.03f)).speed, 0.0);
}

TEST(LowObstacles, NoneIsForgottenWhileItsFootLeavesThePicture) {
  for (const float height : {0.026f, 0.03f, 0.035f, 0.04f}) {
    Robot robot;
    robot.sees(with_plateau(0.74f, height));
    for (float z = 0.73f; z > 0.64f; z -= 0.01f) {
      const Decision decision = robot.sees(with_plateau(z, height));
      EXPECT_EQ(decision.cause, Cause::LowObstacle) << height << " at " << z;
      EXPECT_LT(decision.speed, 0.2) << height << " at " << z;
    }
    EXPECT_EQ(robot.sees(with_plateau(0.64f, height)).speed, 0.0) << height;
    EXPECT_EQ(after_two(robot, Scene()).speed, 0.2) << "the floor before it is seen again";
  }
}

/// Nobody looked for a while, in which the robot rolled on.
TEST(LowObstacles, AKerbMayHaveLeftInAPauseOfTheCamera) {
  const auto after_pause = [](double seconds, float at) {
    Robot robot;
    for (const float z : {0.78f, 0.76f, 0.74f, 0.72f, 0.70f}) robot.sees({kerb(z, 0.05f)});
    robot.waits(seconds);
    for (int i = 0; i < 100; ++i) robot.sees({kerb(at, 0.05f)});
    return robot.sees({kerb(at, 0.05f)});
  };
  constexpr float left = 0.55f;  // [m] from the camera: below its picture
  for (const double pause : {0.3, 0.7, 3.0}) {
    EXPECT_EQ(after_pause(pause, left).cause, Cause::LowObstacle) << pause;
    EXPECT_EQ(after_pause(pause, left).speed, 0.0) << pause;
    EXPECT_EQ(after_pause(pause, 0.68f).cause, Cause::LowObstacle) << "it has stayed in view";
  }
  EXPECT_EQ(after_pause(0.0, left).speed, 0.2) << "from one cloud to the next it was taken away";
}

/// A replay that does not wait takes as long as its computer does.
TEST(LowObstacles, ASlowReplayIsNoPauseOfTheCamera) {
  const auto after_replay = [](double seconds) {
    Settings settings;
    settings.source_timeout = 10.0;
    settings.stamp_tolerance = 0.0;
    Robot robot(settings);
    const auto replays = [&](float z) {
      robot.falls_behind(seconds);
      return robot.sees({kerb(z, 0.05f)});
    };
    for (const float z : {0.78f, 0.76f, 0.74f, 0.72f, 0.70f}) replays(z);
    for (int i = 0; i < 9; ++i) replays(0.55f);
    return replays(0.55f);
  };
  for (const double pace : {0.0, 0.3, 2.0}) EXPECT_EQ(after_replay(pace).speed, 0.2) << pace;
}

TEST(LowObstacles, RobotSlowsBeforeAKerbAboveABorderThatNeverReturns) {
  Robot robot;
  Scene scene({kerb(0.74f, 0.05f)});
  scene.blank_lowest_rows(3);
  EXPECT_EQ(robot.sees(scene).cause, Cause::LowObstacle);
}

TEST(LowObstacles, CorridorOnTheFloorSeesTheSameKerb) {
  Placement camera;
  camera.rows[1][3] = -floor_y;
  Settings settings;
  settings.target_frame = "base_footprint";
  settings.frame_corridor.top = 0.25 + double{floor_y};
  settings.frame_corridor.bottom = -0.20 + double{floor_y};
  Robot robot(settings, camera);
  EXPECT_EQ(robot.sees({kerb(1.0f, 0.05f)}).speed, 0.2);
  EXPECT_EQ(robot.sees({kerb(0.74f, 0.05f)}).cause, Cause::LowObstacle);
  EXPECT_EQ(robot.sees({kerb(0.62f, 0.05f)}).speed, 0.0);
  EXPECT_EQ(after_two(robot, Scene()).speed, 0.2);
}

TEST(LowObstacles, NearerThanAnEdgeThatFlickersDecides) {
  Settings settings;
  settings.limits.danger = 0.73;
  Robot robot(settings);
  const Board low = {0.72f, -0.25f, 0.0f, floor_y - 0.05f, floor_y}, board = {0.745f, 0.05f, 0.20f, -0.2f, 0.1f};
  Board less = board;
  less.x_max = 0.18f;
  robot.sees({low, board});
  const Decision decision = robot.sees({low, less});
  EXPECT_EQ(decision.cause, Cause::LowObstacle);
  EXPECT_EQ(decision.speed, 0.0);
}

TEST(LowObstacles, TimeoutOfLossesForgetsNoneThatIsInSight) {
  Settings settings;
  settings.near_loss.timeout = 0.2;
  Robot robot(settings);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(robot.sees({kerb(0.74f, 0.05f)}).speed, 0.1) << i;
  EXPECT_EQ(robot.sees({kerb(0.62f, 0.05f)}).speed, 0.0);
  for (int i = 0; i < 5; ++i) robot.sees({kerb(0.62f, 0.05f)});
  EXPECT_EQ(robot.sees({kerb(0.62f, 0.05f)}).speed, 0.2) << "out of sight since the timeout";
}

TEST(LowObstacles, RobotStandsForAsLongAsAPlateauFillsItsView) {
  Robot robot;
  for (const float z : {0.76f, 0.74f, 0.72f, 0.70f}) robot.sees(with_plateau(z, 0.05f));
  for (int i = 0; i < 200; ++i) EXPECT_EQ(robot.sees(with_plateau(0.62f, 0.05f)).speed, 0.0);
  EXPECT_EQ(after_two(robot, Scene()).speed, 0.2);
}

TEST(LowObstacles, RobotStandsForAKerbThatHasComeTooNearToReturn) {
  Robot robot;
  for (const float z : {0.74f, 0.72f, 0.70f}) robot.sees({kerb(z, 0.085f)});
  EXPECT_EQ(robot.sees({kerb(0.39f, 0.2f)}).speed, 0.0);
}

/// Every second row and column.
CloudView halved(CloudView view) {
  view.width /= 2, view.height /= 2;
  view.point_step *= 2, view.row_step *= 2;
  return view;
}

TEST(LowObstacles, AKerbOutlivesAChangeOfResolution) {
  Robot robot;
  for (const float z : {0.74f, 0.72f, 0.70f}) robot.sees(with_plateau(z, 0.05f));
  EXPECT_EQ(robot.sees(halved(with_plateau(0.6f, 0.05f).view())).speed, 0.0);
  const Scene free;
  robot.sees(halved(free.view()));
  EXPECT_EQ(robot.sees(halved(free.view())).speed, 0.2);
}

/// Somebody turns a knob while the robot stands before a kerb that hides the floor.
TEST(LowObstacles, AKerbOutlivesAChangeOfTheCorridorThatHoldsItStill) {
  for (const float x_max : {0.31f, 0.4f, 0.29f}) {
    for (const float y_max : {0.2f, 0.205f, 0.15f}) {
      Robot robot;
      for (const float z : {0.74f, 0.72f, 0.70f}) robot.sees(with_plateau(z, 0.05f));
      ASSERT_EQ(robot.sees(with_plateau(0.6f, 0.05f)).speed, 0.0);
      Settings other;
      other.corridor.x_max = x_max, other.corridor.y_max = y_max;
      robot.control().adopt(other);
      for (int i = 0; i < 10; ++i)
        EXPECT_EQ(robot.sees(with_plateau(0.6f, 0.05f)).cause, Cause::LowObstacle) << x_max << ", " << y_max;
      EXPECT_EQ(after_two(robot, Scene()).speed, 0.2);
    }
  }
}

TEST(LowObstacles, AKerbBesideANewCorridorIsNone) {
  Robot robot;
  const auto beside = [](float z) { return Board{z, 0.15f, 0.3f, floor_y - 0.05f, floor_y}; };
  for (const float z : {0.74f, 0.72f, 0.70f}) robot.sees({beside(z)});
  ASSERT_EQ(robot.sees({beside(0.62f)}).speed, 0.0);
  Settings narrow;
  narrow.corridor.x_max = 0.1f;
  robot.control().adopt(narrow);
  EXPECT_EQ(robot.sees({beside(0.62f)}).speed, 0.2);
}

TEST(LowObstacles, RobotDrivesOverWhatItCanClimb) {
  Robot robot;
  for (float z = 0.8f; z > 0.4f; z -= 0.01f) EXPECT_EQ(robot.sees({kerb(z, 0.012f)}).speed, 0.2) << z;
}

TEST(LowObstacles, RobotDrivesOverABumpAndUpARamp) {
  Robot robot;
  for (const float nose_up : {0.0f, 0.03f, -0.05f, 0.05f, 0.0f, -0.03f, 0.0f}) {
    EXPECT_NE(robot.sees(Scene({}, nose_up)).cause, Cause::LowObstacle) << nose_up;
  }
}

TEST(LowObstacles, FootOfAnObstacleIsJudgedByTheDistanceOfTheObstacle) {
  Robot robot;
  for (float z = 0.9f; z > 0.51f; z -= 0.01f) {
    const Decision decision = robot.sees({{z, -0.3f, 0.3f, -1.0f, floor_y}});
    EXPECT_EQ(decision.cause, Cause::Seen) << z;
    EXPECT_EQ(decision.speed, 0.1) << z;
  }
}

TEST(LowObstacles, OneThinBladeOfGrassIsNone) {
  Robot robot;
  for (float z = 0.8f; z > 0.6f; z -= 0.01f) EXPECT_EQ(robot.sees({kerb(z, 0.06f, 0.01f)}).speed, 0.2) << z;
}

TEST(LowObstacles, RobotDrivesPastAKerbBesideTheCorridor) {
  Robot robot;
  for (float z = 0.8f; z > 0.5f; z -= 0.01f) {
    EXPECT_EQ(robot.sees({{z, 0.31f, 0.6f, floor_y - 0.06f, floor_y}}).speed, 0.2) << z;
  }
}

/// At its side the picture shows no floor in the corridor, but a shoe that stands out of it.
TEST(LowObstacles, RobotDrivesOnWhenAShoeHasLeftTheCorridorAside) {
  for (const float z : {0.60f, 0.64f, 0.68f}) {
    for (const float step : {-0.05f, 0.05f}) {
      for (const float x_max : {0.3f, 0.2f}) {
        Settings settings;
        settings.corridor.x_min = -x_max, settings.corridor.x_max = x_max;
        Robot robot(settings);
        const auto shoe = [z](float x) { return Board{z, x - 0.05f, x + 0.05f, floor_y - 0.08f, floor_y}; };
        robot.sees(Scene());
        EXPECT_EQ(robot.sees({shoe(0.0f)}).cause, Cause::LowObstacle) << z;
        for (float x = step; std::abs(x) < x_max; x += step)
          EXPECT_LT(robot.sees({shoe(x)}).speed, 0.2) << z << ", " << x;
        for (float x = x_max; x < 0.6f; x += 0.05f) robot.sees({shoe(std::copysign(x, step))});
        EXPECT_EQ(after_two(robot, Scene()).speed, 0.2) << z << ", " << step << ", " << x_max;
      }
    }
  }
}

TEST(LowObstacles, ResetForgetsThemAndSoDoesSwitchingTheMemoryOff) {
  Robot robot;
  for (const float z : {0.74f, 0.72f, 0.70f}) robot.sees(with_plateau(z, 0.05f));
  EXPECT_EQ(robot.sees(with_plateau(0.6f, 0.05f)).speed, 0.0);
  robot.control().forget_losses();
  EXPECT_EQ(robot.sees(with_plateau(0.6f, 0.05f)).speed, 0.2);

  Settings settings;
  settings.near_loss.distance = 0.0;
  Robot blunt(settings);
  for (const float z : {0.74f, 0.72f, 0.70f, 0.65f}) EXPECT_EQ(blunt.sees({kerb(z, 0.085f)}).speed, 0.2);
}

}  // namespace
}  // namespace safety_control_cloud
