// SPDX-License-Identifier: BSD-3-Clause
// What the guard does not know by a laser whose message names angles at which nobody measures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

/// What a filter puts in place of beams that it takes away.
constexpr float blanks[] = {std::numeric_limits<float>::quiet_NaN(), 0.0f, 11.0f};

Settings with_a_laser_alone(double unseen_speed) {
  Settings settings = guard_settings();
  settings.unseen_speed = unseen_speed;
  settings.sensors = {{"laser", InputKind::Scan, "scan", true, {}}};
  return settings;
}

struct RobotWithALaser : RobotWithSensors {
  using RobotWithSensors::RobotWithSensors;

  /// Looks, and somebody says the same after each.
  Guarded looks(int times, const Twist2& twist = {}) {
    for (int i = 0; i < times; ++i) {
      pass(0.05);
      see_scan(0);
      wants(twist);
    }
    return wants(twist);
  }
};

/// Of a whole turn but for what a filter takes away beyond so many degrees to each side.
RobotWithALaser with_masked_laser(float blank, double unseen_speed, int half = 100) {
  RobotWithALaser robot(with_a_laser_alone(unseen_speed));
  for (int degrees = 0; degrees < 360; ++degrees)
    if (std::abs(degrees - 180) > half) robot.ranges[static_cast<std::size_t>(degrees)] = blank;
  return robot;
}

TEST(MaskedLasers, WhereALaserHasNeverMeasuredItDoesNotLook) {
  constexpr double unseen_speed = 0.1;
  for (const float blank : blanks) {
    RobotWithALaser robot = with_masked_laser(blank, unseen_speed);
    const auto drives = [&](const Twist2& twist) { return robot.looks(10, twist); };
    const Guarded behind = drives({-0.4, 0.0, 0.0});
    EXPECT_NEAR(behind.given.linear[0], -unseen_speed, 1e-6) << blank << ": " << behind.reason;
    EXPECT_EQ(drives({0.4, 0.0, 0.0}).factor, 1.0) << blank << ": it looks there";
    EXPECT_EQ(drives({0.0, 0.0, 0.5}).factor, 1.0) << blank;
    std::fill(robot.ranges.begin(), robot.ranges.end(), 5.0f);
    EXPECT_EQ(drives({-0.4, 0.0, 0.0}).factor, 1.0) << blank << ": by now it has";
  }
}

TEST(MaskedLasers, WhereItNoLongerMeasuresItNoLongerLooks) {
  constexpr double unseen_speed = 0.1;
  for (const float blank : blanks) {
    for (const bool zero_is_inf : {false, true}) {
      Settings settings = with_a_laser_alone(unseen_speed);
      settings.sensors[0].own["zero_is_inf"] = zero_is_inf ? 1.0 : 0.0;
      RobotWithALaser robot(settings);
      const auto looks = [&](int times) {
        robot.looks(times);
        return robot.wants({0.4, 0.0, 0.0});
      };
      EXPECT_EQ(looks(20).factor, 1.0);
      std::fill(robot.ranges.begin() + 120, robot.ranges.begin() + 240, blank);
      const Guarded answer = looks(40);
      const bool says_free = zero_is_inf && blank == 0.0f;
      EXPECT_NEAR(answer.given.linear[0], says_free ? 0.4 : unseen_speed, 1e-6) << blank << ": " << answer.reason;
      std::fill(robot.ranges.begin() + 120, robot.ranges.begin() + 240, 5.0f);
      EXPECT_EQ(looks(2).factor, 1.0) << blank << ": it looks again";
    }
  }
}

TEST(MaskedLasers, ZeroIsTooCloseWhereNothingIsUnlessItSaysWhatInfinitySays) {
  for (const bool inf_is_free : {false, true}) {
    for (const bool zero_is_inf : {false, true}) {
      Settings settings = with_a_laser_alone(0.1);
      settings.sensors[0].own = {{"inf_is_free", inf_is_free ? 1.0 : 0.0}, {"zero_is_inf", zero_is_inf ? 1.0 : 0.0}};
      RobotWithALaser robot(settings);
      robot.range_min = 0.0;
      for (std::size_t degrees = 120; degrees < 240; ++degrees) robot.ranges[degrees] = 0.0f;
      const Guarded answer = robot.looks(20, {0.4, 0.0, 0.0});
      EXPECT_EQ(answer.factor, zero_is_inf ? 1.0 : 0.0) << inf_is_free << ": " << answer.reason;
    }
  }
}

/// Whether the rest of the turn is not named, or a filter took it away.
TEST(MaskedLasers, WhereALaserOfMoreThanHalfATurnDoesNotLookItDoesNotHoweverThatIsSaid) {
  constexpr double unseen_speed = 0.1;
  for (const int degrees : {220, 260, 270, 300}) {  // it looks at, ahead
    for (const bool is_named : {false, true}) {
      RobotWithALaser robot(with_a_laser_alone(unseen_speed));
      const std::size_t beams = static_cast<std::size_t>(degrees), first = (360 - beams) / 2;
      if (is_named) {
        robot.ranges.assign(beams, 8.0f);
        robot.first_bearing = -0.5 * degrees * pi / 180.0;
      } else {
        for (std::size_t i = 0; i < 360; ++i) robot.ranges[i] = i < first || i >= first + beams ? blanks[0] : 8.0f;
      }
      for (const Twist2& back : {Twist2{-0.4, 0.0, 0.0}, Twist2{-0.4, 0.0, 0.1}, Twist2{-0.4, 0.04, 0.0}})
        EXPECT_NEAR(robot.looks(10, back).given.linear[0], -unseen_speed, 0.02)
            << degrees << ", " << is_named << ", " << back.w << ", " << back.vy;
      EXPECT_EQ(robot.looks(10, {0.4, 0.0, 0.0}).factor, 1.0) << degrees << ", " << is_named;
    }
  }
}

/// What lies beyond its sides is no gap: an arc of a long robot, part of which is in sight, passes.
TEST(MaskedLasers, ALaserOfHalfATurnHasNoGap) {
  Settings settings = with_a_laser_alone(0.1);
  settings.footprint.text = "[[-0.4,-0.25],[0.4,-0.25],[0.4,0.25],[-0.4,0.25]]";
  RobotWithALaser robot(settings);
  robot.laser_place = laser_at(0.2, 0.0, 0.4);
  robot.ranges.assign(181, 8.0f);
  robot.first_bearing = -0.5 * pi;
  for (const Twist2& twist : {Twist2{0.001, 0.0, 0.5}, Twist2{0.05, 0.0, 0.5}, Twist2{0.3, 0.0, 1.5}}) {
    const Guarded answer = robot.looks(60, twist);
    EXPECT_EQ(answer.factor, 1.0) << twist.vx << ": " << answer.reason;
  }
}

TEST(MaskedLasers, WhatItShowedStaysWhereItNoLongerMeasures) {
  for (const float blank : blanks) {
    RobotWithALaser robot(with_a_laser_alone(0.7));
    const auto looks = [&](int times) {
      for (int i = 0; i < times; ++i) {
        robot.control.note_odometry(robot.now.ros + 0.05, {}, {});
        robot.looks(1);
      }
      return robot.wants({0.6, 0.0, 0.0});
    };
    std::fill(robot.ranges.begin() + 165, robot.ranges.begin() + 195, 0.7f);
    const double before = looks(20).factor;
    EXPECT_LT(before, 0.9);
    std::fill(robot.ranges.begin() + 165, robot.ranges.begin() + 195, blank);
    EXPECT_LE(looks(80).factor, before + 0.05) << blank;
  }
}

/// Be it so narrow that it is no gap, as behind a mast.
TEST(MaskedLasers, WhatIsRememberedIsNotSeenToGoWhereALaserHasNeverMeasured) {
  for (const auto& [blank, half, wide] :
       {std::tuple(blanks[0], 100, 10), std::tuple(blanks[1], 100, 10), std::tuple(blanks[2], 100, 10),
        std::tuple(blanks[0], 174, 2), std::tuple(blanks[1], 174, 2), std::tuple(blanks[2], 176, 1)}) {
    RobotWithALaser robot = with_masked_laser(blank, 0.7, half);
    const std::vector<float> free = robot.ranges;
    const auto masked = [half = half](int degrees) { return std::abs(degrees - 180) > half; };
    Pose2 pose;
    const auto turns = [&](int looks, double turning) {
      for (int i = 0; i < looks; ++i) {
        robot.pass(0.05);
        pose.heading += 0.05 * turning;
        robot.ranges = free;
        const auto middle = static_cast<int>(std::lround(180.0 - pose.heading * 180.0 / pi));
        for (int degrees = middle - wide; degrees <= middle + wide; ++degrees) {
          const int seen = (degrees + 360) % 360;
          if (!masked(seen)) robot.ranges[static_cast<std::size_t>(seen)] = 0.8f;
        }
        robot.control.note_odometry(robot.now.ros, pose, {0.0, 0.0, turning});
        robot.see_scan(0);
        robot.wants({0.0, 0.0, turning});
      }
    };
    turns(20, 0.0);
    turns(20, pi);  // in which it leaves what the laser shows
    turns(60, 0.0);
    const Guarded& answer = robot.wants({-0.6, 0.0, 0.0});
    EXPECT_LT(answer.factor, 0.9) << blank << ": " << answer.reason;
    ASSERT_TRUE(answer.point) << answer.reason;
    EXPECT_NEAR(answer.point->x, -0.8, 0.1) << answer.reason;
  }
}

}  // namespace
}  // namespace safety_control_cloud
