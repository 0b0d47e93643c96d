// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "../memory/lens.hpp"
#include "robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

constexpr double pi = 2.0 * quarter, out_of_view = 150.0 / 180.0 * pi;

Settings laser_settings() {
  Settings settings = remembering();
  settings.input = InputKind::Scan;
  return settings;
}

Placing laser_in_the_middle() {
  Eigen::Matrix<double, 3, 4> place;
  place << 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.2;
  return placing_of(place);
}

/// A robot that turns before a pole, with a laser that looks 100 degrees to each side.
struct RobotBesideAPole : RobotWithOdometry {
  RobotBesideAPole(double diameter, double noise, unsigned seed)
      : RobotWithOdometry(laser_settings()), radius(0.5 * diameter), random(seed), error(0.0, noise) {}

  double radius, distance = 0.45;
  double lasts = 0.0;  ///< [s] a scan, whose stamp is that of its first beam
  std::mt19937 random;
  std::normal_distribution<double> error;
  std::vector<float> ranges = std::vector<float>(361);
  ScanPoints scans;

  /// The pole stands where the robot looked at first.
  void looks(double turning = 0.0) {
    Scan scan;
    scan.angle_min = -100.0 / 180.0 * pi, scan.angle_max = -scan.angle_min;
    scan.angle_increment = 2.0 * scan.angle_max / 360.0;
    scan.time_increment = lasts / 360.0, scan.scan_time = 0.05, scan.range_min = 0.1, scan.range_max = 10.0;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const double ago = lasts * (1.0 - static_cast<double>(i) / 360.0);
      const double off = scan.angle_min + scan.angle_increment * static_cast<double>(i) + pose.heading - turning * ago;
      const bool hits = std::cos(off) > 0.0 && std::abs(distance * std::sin(off)) < radius;
      ranges[i] = static_cast<float>((hits ? distance - radius : 4.0) + error(random));
    }
    scan.ranges = ranges.data(), scan.size = ranges.size();
    pass(0.05);
    control.note_odometry(now.ros, pose, {0.0, 0.0, turning});
    control.see(scans.of(scan), {now.ros - lasts, laser_in_the_middle(), "laser", "laser"}, now);
    wants({});
  }

  void turns_away(double speed) {
    for (int i = 0; i < 10; ++i) looks();
    for (; pose.heading < out_of_view; pose.heading += 0.05 * speed) looks(speed);
    for (int i = 0; i < 20; ++i) looks();
  }
};

TEST(ThinThings, ARememberedPoleStaysHoweverNoisyTheLaserIs) {
  for (const double diameter : {0.015, 0.03}) {
    for (const double noise : {0.01, 0.03}) {
      int forgotten = 0;
      for (unsigned seed = 0; seed < 100; ++seed) {
        RobotBesideAPole robot(diameter, noise, seed);
        robot.turns_away(0.25 + 0.02 * seed);
        const double there = -robot.pose.heading;
        if (robot.wants({0.6 * std::cos(there), 0.6 * std::sin(there), 0.0}).factor >= 1.0) ++forgotten;
      }
      EXPECT_EQ(forgotten, 0) << diameter << " m thick, noise of " << noise << " m";
    }
  }
}

/// It is seen while the robot turns past it, and never else.
TEST(ThinThings, APoleIsRememberedWhereItStandsThoughAScanTakesItsTime) {
  for (const double lasts : {0.0, 0.1, 0.2}) {
    for (const double speed : {0.5, 1.5, 3.0, -0.5, -1.5, -3.0}) {
      RobotBesideAPole robot(0.05, 0.005, 7);
      robot.lasts = lasts;
      const double side = speed > 0.0 ? 1.0 : -1.0;
      robot.pose.heading = -side * out_of_view;
      for (int i = 0; i < 10; ++i) robot.looks();
      for (; side * robot.pose.heading < out_of_view; robot.pose.heading += 0.05 * speed) robot.looks(speed);
      for (int i = 0; i < 20; ++i) robot.looks();
      const double there = -robot.pose.heading;
      EXPECT_LT(robot.wants({0.6 * std::cos(there), 0.6 * std::sin(there), 0.0}).factor, 1.0) << lasts << ", " << speed;
    }
  }
}

/// What an Xtion in VGA sees in three of its rows: a bar of 5 mm on the right, 0.9 m away.
Board bar_in_rows(const Lens& lens, std::size_t first) {
  constexpr float away = 0.9f;
  const auto at = [&](double row) { return away * static_cast<float>((row - lens.down) / lens.focal); };
  const auto row = static_cast<double>(first);
  return {away, 0.4f * away, 0.55f * away, at(row - 0.5), at(row + 2.5)};
}

/// Of the rows, each look takes every sixth.
TEST(ThinThings, ABarThatLiesBetweenTwoRowsIsRemembered) {
  const Lens vga{640, 480, 554.26, 319.5, 239.5};
  for (std::size_t first_row = 210; first_row < 216; ++first_row) {
    const auto points = vga.points({bar_in_rows(vga, first_row)});
    RobotWithOdometry robot;
    for (int i = 0; i < 20; ++i) {
      robot.pass(0.05);
      robot.control.note_odometry(robot.now.ros, robot.pose, {});
      robot.see(vga.view_of_rows(points));
      robot.wants({});
    }
    robot.turns(pi - 0.49, robot.hall);  // it is behind
    const Guarded& answer = robot.asked({-0.7, 0.0, 0.0});
    EXPECT_LT(answer.factor, 1.0) << "from row " << first_row << " on";
  }
}

}  // namespace
}  // namespace safety_control_cloud
