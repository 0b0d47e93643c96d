// SPDX-License-Identifier: BSD-3-Clause
// A sensor that is not required and in doubt, and what it knew of before.
#include <gtest/gtest.h>

#include "robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

constexpr Twist2 forward{0.3, 0.0, 0.0}, back{-0.1, 0.0, 0.0}, about{0.0, 0.0, 0.5};

Scene post_at(float away) { return Scene({post(away, 0.0f)}); }
Scene wall_at(float away) { return Scene({{away, -9.0f, 9.0f, -9.0f, floor_y}}); }

/// Its rear camera is not required, and something comes up to it that its laser does not see.
struct RobotBeforeWhatComes : RobotWithSensors {
  explicit RobotBeforeWhatComes(Scene (*at)(float), const Settings& settings = with_sensors())
      : RobotWithSensors(settings) {
    for (const float away : {0.7f, 0.6f, 0.5f, 0.45f, 0.35f}) {
      behind = at(away);
      drives({});
    }
  }

  void expect_closed_behind(Cause cause) {
    for (const Twist2& twist : {back, about}) {
      EXPECT_EQ(drives(twist).factor, 0.0) << wants(twist).reason;
      EXPECT_EQ(wants(twist).cause, cause) << wants(twist).reason;
      EXPECT_EQ(wants(twist).sensor, "rear");
    }
    EXPECT_EQ(drives(forward).factor, 1.0) << wants(forward).reason;
  }
};

TEST(LeftBehind, WhatWasLostClosesItsWayThoughTheCameraFallsSilent) {
  RobotBeforeWhatComes robot(post_at);
  robot.rear_shows = false;
  for (int i = 0; i < 3; ++i) robot.expect_closed_behind(Cause::NearLoss);
  robot.rear_shows = true;
  robot.behind = Scene();
  EXPECT_EQ(robot.drives(back).factor, 1.0) << robot.wants(back).reason;
}

/// With odometry, to a post that comes nearer than its rear camera sees.
struct RobotThatBacksUp : RobotWithSensors {
  explicit RobotThatBacksUp(const Settings& settings = with_sensors()) : RobotWithSensors(settings) {
    for (float away = 0.8f; away > 0.355f; away -= 0.01f) {
      behind = Scene({post(away, 0.02f, 0.06f)});
      goes_on(0.05, {-0.2, 0.0, 0.0});
      pose.place.x -= 0.01;
    }
    pose.place.x += 0.01;
  }

  Pose2 pose;

  void goes_on(double seconds, const Twist2& twist = {}) {
    for (double t = 0.0; t < seconds; t += 0.05) {
      control.note_odometry(now.ros + 0.05, pose, twist);
      drives_on({});
    }
  }
};

TEST(LeftBehind, WhatIsKeptAsPlacesClosesTheWaysToThemAloneWhateverTheCameraSays) {
  RobotThatBacksUp robot;
  robot.goes_on(1.0);
  robot.rear_shows = false;
  for (int i = 0; i < 40; ++i) {
    robot.goes_on(0.05);
    robot.control.see(Unreadable{"no fields"}, {robot.now.ros, turned_xtion(pi), "camera", "camera"}, robot.now, rear);
    EXPECT_EQ(robot.wants(about).factor, 1.0) << i << ": " << robot.wants(about).reason;
    EXPECT_LT(robot.wants({-0.3, 0.0, 0.0}).factor, 0.5) << i << ": " << robot.wants({-0.3, 0.0, 0.0}).reason;
  }
}

/// With odometry it is kept as places, which are forgotten when they have not been shown for so long, be the camera
/// that lost it silent since soon before or not; and other settings may keep none.
TEST(LeftBehind, WhatWasKeptAsPlacesClosesItsWayOnceTheyAreForgotten) {
  for (const bool are_settings_others : {false, true}) {
    Settings settings = with_sensors();
    RobotThatBacksUp robot(settings);
    const auto goes_on = [&](double seconds) { robot.goes_on(seconds); };
    goes_on(are_settings_others ? 5.0 : 20.0);
    EXPECT_EQ(robot.wants(about).factor, 1.0) << robot.wants(about).reason;
    robot.rear_shows = false;
    goes_on(1.0);
    if (are_settings_others) {
      settings.memory_distance = 0.0;
      robot.control.adopt(settings);
    }
    goes_on(are_settings_others ? 1.0 : 12.0);
    EXPECT_EQ(robot.wants(back).factor, 0.0) << robot.wants(back).reason;
    EXPECT_EQ(robot.wants(back).cause, Cause::NearLoss) << robot.wants(back).reason;
  }
}

TEST(LeftBehind, WhatWasLostInTheVeryLastLookToo) {
  RobotWithSensors robot;
  for (const float away : {0.7f, 0.6f, 0.5f, 0.45f}) {
    robot.behind = post_at(away);
    robot.drives({});
  }
  robot.behind = post_at(0.35f);
  robot.drives_on({});
  robot.rear_shows = false;
  EXPECT_EQ(robot.drives(back).factor, 0.0) << robot.wants(back).reason;
}

TEST(LeftBehind, WhatWasLostClosesItsWayThoughTheCameraLooksElsewhere) {
  RobotBeforeWhatComes robot(post_at);
  robot.rear_heading = 1.5;
  robot.behind = Scene();
  robot.expect_closed_behind(Cause::NearLoss);
}

TEST(LeftBehind, WhatComesUntilItHidesAllClosesItsWay) {
  RobotBeforeWhatComes robot(wall_at);
  robot.expect_closed_behind(Cause::Blind);
}

TEST(LeftBehind, WhatHidAllStaysThoughTheBlindCameraFallsSilent) {
  RobotBeforeWhatComes robot(wall_at);
  robot.rear_shows = false;
  for (int i = 0; i < 3; ++i) robot.drives(back);
  robot.expect_closed_behind(Cause::NearLoss);
  robot.rear_shows = true;
  robot.expect_closed_behind(Cause::NearLoss);
}

TEST(LeftBehind, WhatOnlyHidTheFloorStaysThoughTheCameraGoesBlind) {
  RobotWithSensors robot;
  ASSERT_EQ(robot.drives(back).factor, 1.0);
  robot.behind = post_at(0.35f);
  ASSERT_EQ(robot.drives(back).cause, Cause::NearLoss);
  robot.behind = wall_at(0.1f);
  EXPECT_EQ(robot.drives(back).factor, 0.0) << robot.wants(back).reason;
}

TEST(LeftBehind, IsForgottenAfterNearLossTimeout) {
  Settings settings = with_sensors();
  settings.near_loss.timeout = 5.0;
  RobotBeforeWhatComes robot(post_at, settings);
  robot.rear_shows = false;
  EXPECT_EQ(robot.drives(back).factor, 0.0);
  for (int i = 0; i < 11; ++i) robot.drives({});
  EXPECT_EQ(robot.drives(back).factor, 1.0) << robot.wants(back).reason;
}

TEST(LeftBehind, BlindnessBeforeWhichNothingWasNearIsAsGoodAsAbsence) {
  RobotWithSensors robot;
  ASSERT_EQ(robot.drives(back).factor, 1.0);
  robot.behind = wall_at(0.1f);  // somebody covers it
  EXPECT_EQ(robot.drives(back).factor, 1.0) << robot.wants(back).reason;
  ASSERT_EQ(robot.wants(back).doubts.size(), std::size_t{1});
  EXPECT_NE(robot.wants(back).doubts[0].find("rear: BLIND"), std::string::npos) << robot.wants(back).doubts[0];
}

TEST(LeftBehind, WhatWasLostBeforeARestartClosesEveryWayUntilTheCameraSpeaks) {
  RobotBeforeWhatComes before(post_at);
  RobotWithSensors robot;
  ASSERT_TRUE(robot.control.recall(before.control.remembered()));
  robot.rear_shows = false;
  for (const Twist2& twist : {back, about, forward}) {
    EXPECT_EQ(robot.drives(twist).factor, 0.0) << robot.wants(twist).reason;
    EXPECT_EQ(robot.wants(twist).cause, Cause::NearLoss) << robot.wants(twist).reason;
  }
  robot.rear_shows = true;
  EXPECT_EQ(robot.drives(forward).factor, 1.0) << robot.wants(forward).reason;
  EXPECT_EQ(robot.drives(back).factor, 1.0) << robot.wants(back).reason;
}

TEST(LeftBehind, ResetForgetsIt) {
  RobotBeforeWhatComes robot(post_at);
  robot.rear_shows = false;
  ASSERT_EQ(robot.drives(back).factor, 0.0);
  robot.control.forget_losses();
  EXPECT_EQ(robot.drives(back).factor, 1.0) << robot.wants(back).reason;
}

TEST(LeftBehind, WithNobodyElseToBelieveItStands) {
  Settings settings = with_sensors(false);
  settings.sensors.erase(settings.sensors.begin());  // rear and laser are left
  GuardedRobot robot(settings);
  for (const float away : {0.7f, 0.6f, 0.5f, 0.45f, 0.35f}) {
    const Scene scene = post_at(away);
    for (int i = 0; i < 5; ++i) {
      robot.pass(0.05);
      robot.see(scene.view(), turned_xtion(pi), 0);
    }
  }
  robot.pass(2.0);
  EXPECT_EQ(robot.wants({0.05, 0.0, 0.0}).factor, 0.0) << robot.wants({0.05, 0.0, 0.0}).reason;
}

}  // namespace
}  // namespace safety_control_cloud
