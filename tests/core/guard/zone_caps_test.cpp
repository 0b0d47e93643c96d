// SPDX-License-Identifier: BSD-3-Clause
// The tutorial's zones as caps on what somebody else wants.
#include <gtest/gtest.h>

#include "robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

constexpr Twist2 forward{0.6, 0.0, 0.0};

Settings capped() {
  Settings settings = guard_settings();
  settings.zone_caps = true;
  settings.unseen_speed = 0.7;
  return settings;
}

/// A board so far before base_frame's origin, as the drive mode measures it there.
Scene board_at(double distance) { return Scene({{static_cast<float>(distance + 0.087), -9.0f, 9.0f, -9.0f, floor_y}}); }

double given(const Scene& scene, const Twist2& twist, const Settings& settings = capped()) {
  return GuardedRobot(settings).drives(scene, twist).given.linear[0];
}

TEST(ZoneCaps, AreOffUnlessAskedFor) { EXPECT_GT(given(board_at(0.9), forward, guard_settings()), 0.3); }

TEST(ZoneCaps, EachZoneHasItsSpeedAsInModeDrive) {
  const Settings settings = capped();
  EXPECT_NEAR(given(Scene{}, forward), settings.speeds.safe, 1e-12);
  EXPECT_NEAR(given(board_at(settings.limits.warning + 0.02), forward), settings.speeds.safe, 1e-12);
  EXPECT_NEAR(given(board_at(settings.limits.warning - 0.02), forward), settings.speeds.warning, 1e-12);
  EXPECT_NEAR(given(board_at(settings.limits.danger + 0.02), forward), settings.speeds.warning, 1e-12);
  EXPECT_EQ(given(board_at(settings.limits.danger - 0.02), forward), 0.0);
}

TEST(ZoneCaps, ACommandThatIsSlowerPassesEqualInEveryBit) {
  EXPECT_EQ(given(board_at(0.9), {0.1 / 3.0, 0.0, 0.0}), 0.1 / 3.0);
}

TEST(ZoneCaps, TheWholeIsScaledAndTheReasonNamesTheZone) {
  GuardedRobot robot(capped());
  const Guarded& answer = robot.drives(Scene{}, {0.4, 0.0, 0.2});
  EXPECT_NEAR(answer.given.angular[2], 0.1, 1e-12);
  EXPECT_EQ(answer.reason.substr(0, 9), "zone Safe");
  EXPECT_EQ(answer.sensor, "cloud");
}

TEST(ZoneCaps, WhatDoesNotLeadToWhereASensorLooksIsNotCapped) {
  GuardedRobot robot(capped());
  const Scene near = board_at(0.48);
  EXPECT_EQ(robot.drives(near, {-0.3, 0.0, 0.0}).factor, 1.0);
  EXPECT_EQ(robot.drives(near, {0.0, 0.0, 1.0}).factor, 1.0);
}

TEST(ZoneCaps, NeverGiveMoreThanTheLaw) {
  Settings fast = capped();
  fast.speeds = {1.0, 1.0};
  fast.limits.danger = 0.3;
  Settings without = fast;
  without.zone_caps = false;
  for (double distance = 0.3; distance < 1.2; distance += 0.05)
    EXPECT_DOUBLE_EQ(given(board_at(distance), forward, fast), given(board_at(distance), forward, without)) << distance;
}

/// A laser whose x axis leads back, which sees something at its back: so before the robot. And one that looks back.
TEST(ZoneCaps, FollowTheCorridorInWhichALaserSeesWhichever) {
  for (const std::size_t beams : {360, 180}) {
    Settings settings = capped();
    settings.sensors = {{"laser", InputKind::Scan, "scan", true, {}}};
    RobotWithSensors robot(settings);
    Eigen::Matrix<double, 3, 4> place;
    place << -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0.2;
    robot.laser_place = placing_of(place);
    const bool all_around = beams == 360;
    robot.ranges.assign(beams, 5.0f);
    robot.first_bearing = all_around ? 0.0 : -pi / 2.0;
    const std::size_t there = all_around ? 180 : 90;  // before the robot, and behind it
    for (std::size_t i = there - 15; i <= there + 15; ++i) robot.ranges[i] = 0.48f;
    const double toward = all_around ? 0.2 : -0.2;
    const auto speed = [&](double wanted) {
      for (int i = 0; i < 10; ++i) {
        robot.pass(0.05);
        robot.see_scan(0);
        robot.wants({wanted, 0.0, 0.0});
      }
      return robot.wants({wanted, 0.0, 0.0}).given.linear[0];
    };
    EXPECT_EQ(speed(toward), 0.0) << beams;
    EXPECT_EQ(speed(-toward), -toward) << beams;
  }
}

}  // namespace
}  // namespace safety_control_cloud
