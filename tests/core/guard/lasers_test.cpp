// SPDX-License-Identifier: BSD-3-Clause
// What the guard knows by a laser, wherever it looks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

TEST(Lasers, ALaserSeesBesideAndBehind) {
  RobotWithSensors to_the_right, backward, robot;
  for (RobotWithSensors* one : {&to_the_right, &backward, &robot}) {
    one->rear_shows = false;
    one->shows_beside_it();
  }
  const Guarded& left = robot.drives({0.0, 0.5, 0.0});
  EXPECT_LT(left.factor, 1.0);
  EXPECT_EQ(left.sensor, "laser");
  ASSERT_TRUE(left.point);
  EXPECT_NEAR(left.point->y, 0.35, 0.03);
  EXPECT_EQ(to_the_right.drives({0.0, -0.3, 0.0}).factor, 1.0);
  EXPECT_EQ(backward.drives({-0.3, 0.0, 0.0}).factor, 1.0) << "the laser looks there";
}

/// Some drivers count bearings from 0 to a whole turn.
TEST(Lasers, ALaserSeesWhatHasGoneFromWhereverItsBearingsBegin) {
  for (const double first : {-pi, 0.0, -0.5 * pi}) {
    for (const std::size_t bearing : {30, 100, 200, 290, 345, 354, 357}) {  // [degrees] from the first on
      RobotWithSensors robot;
      robot.first_bearing = first;
      const auto stands = [&] {
        for (int i = 0; i < 20; ++i) {
          robot.control.note_odometry(robot.now.ros, {}, {});
          robot.drives_on({});
        }
      };
      for (std::size_t i = 0; i < 7; ++i) robot.ranges[(bearing + i) % 360] = 0.45f;
      stands();
      std::fill(robot.ranges.begin(), robot.ranges.end(), 5.0f);
      stands();
      const double there = first + static_cast<double>(bearing + 3) * pi / 180.0;
      const Guarded& answer = robot.wants({0.6 * std::cos(there), 0.6 * std::sin(there), 0.0});
      EXPECT_EQ(answer.factor, 1.0) << first << ", " << bearing << ": " << answer.sensor << ", " << answer.reason;
    }
  }
}

/// A rail, 8 mm thick, of which the camera says more than the laser that looks past it.
TEST(Lasers, WhatACameraShowsBesideThePlaneOfALaserHasNotGone) {
  Scene with_rail({{0.6f, -0.3f, 0.3f, 0.089f, 0.097f}}), without;
  for (Scene* scene : {&with_rail, &without}) scene->blank_farther_than(1.0f);  // nothing is seen behind it
  for (const bool is_there : {true, false}) {
    RobotWithSensors robot;
    Pose2 pose;
    const auto passes = [&](int looks, double turning) {
      for (int i = 0; i < looks; ++i) {
        pose.heading += 0.05 * turning;
        robot.control.note_odometry(robot.now.ros + 0.05, pose, {0.0, 0.0, turning});
        robot.drives_on({});
      }
    };
    robot.ahead = is_there ? with_rail : without;
    passes(20, 0.0);
    robot.ahead = without;
    passes(10, pi);
    passes(10, 0.0);
    const Guarded& answer = robot.wants({0.0, -0.6, 0.0});
    EXPECT_EQ(answer.factor < 1.0, is_there) << answer.sensor << ", " << answer.reason;
  }
}

TEST(Lasers, AWholeScanOfInfinitiesIsBlindUnlessTheyAreFree) {
  Settings free = with_sensors();
  free.sensors[laser].own["inf_is_free"] = 1.0;
  for (const bool is_free : {false, true}) {
    RobotWithSensors robot(is_free ? free : with_sensors());
    robot.ranges.assign(360, std::numeric_limits<float>::infinity());
    const Guarded& answer = robot.drives({-0.3, 0.0, 0.0});
    EXPECT_EQ(answer.factor, is_free ? 1.0 : 0.0) << answer.reason;
    EXPECT_EQ(answer.cause, is_free ? Cause::Seen : Cause::Blind);
  }
}

TEST(Lasers, ZerosAreAsFreeAsInfinitiesWhereTheySayTheSame) {
  for (const bool zero_is_inf : {false, true}) {
    Settings settings = with_sensors();
    settings.sensors[laser].own = {{"inf_is_free", 1.0}, {"zero_is_inf", zero_is_inf ? 1.0 : 0.0}};
    RobotWithSensors robot(settings);
    robot.ranges.assign(360, 0.0f);
    EXPECT_EQ(robot.drives({-0.3, 0.0, 0.0}).cause, zero_is_inf ? Cause::Seen : Cause::Blind);
  }
}

/// Beside a robot like a T, which has a wing on each side, before one of them as it backs off.
TEST(Lasers, WhatABlindOneShowedBeforeALiveChangeStillCounts) {
  for (const bool remembers : {true, false}) {
    for (const bool changed : {false, true}) {
      Settings settings = guard_settings();
      settings.sensors = {{"laser", InputKind::Scan, "scan", true, {}}};
      settings.footprint.text =
          "[[-0.5,-0.15],[0.2,-0.15],[0.2,-0.5],[0.4,-0.5],[0.4,0.5],[0.2,0.5],[0.2,0.15],[-0.5,0.15]]";
      settings.memory_distance = remembers ? 1.5 : 0.0;
      RobotWithSensors robot(settings);
      robot.ranges.assign(240, 5.0f);
      robot.first_bearing = -2.0 * pi / 3.0;
      const auto stands = [&] {
        for (int i = 0; i < 10; ++i) {
          robot.pass(0.05);
          robot.control.note_odometry(robot.now.ros, {}, {});
          robot.see_scan(0);
          robot.wants({});
        }
      };
      const auto post = static_cast<std::size_t>(120.0 + std::atan2(0.4, 0.12) * 180.0 / pi);
      for (std::size_t i = post - 3; i <= post + 3; ++i) robot.ranges[i] = 0.4f;
      stands();
      ASSERT_LT(robot.wants({-0.1, 0.0, 0.0}).factor, 0.9) << robot.wants({}).reason;
      settings.max_speed = 0.6;
      if (changed) robot.control.adopt(settings);
      robot.ranges.assign(240, std::numeric_limits<float>::quiet_NaN());
      stands();
      const Guarded& answer = robot.wants({-0.1, 0.0, 0.0});
      EXPECT_LT(answer.factor, 0.95) << remembers << changed << ": " << answer.reason;
      EXPECT_EQ(answer.cause == Cause::NoCloud, changed && !remembers) << answer.reason;
    }
  }
}

TEST(Lasers, ABlindLaserThatLooksAllAroundLeavesNoWayAway) {
  RobotWithSensors robot;
  ASSERT_EQ(robot.drives({-0.1, 0.0, 0.0}).factor, 1.0);
  robot.ranges.assign(360, std::numeric_limits<float>::quiet_NaN());
  for (const Twist2& twist : {Twist2{0.1, 0.0, 0.0}, Twist2{-0.1, 0.0, 0.0}, Twist2{0.0, 0.1, 0.0}})
    EXPECT_EQ(robot.drives(twist).factor, 0.0) << twist.vx << " " << twist.vy;
}

TEST(Lasers, AScanWhosePlaneLeavesTheBandIsNoSight) {
  for (const Placing& place : {laser_at(0.02), laser_at(0.9), laser_at(0.2, 0.4), laser_at(0.2, pi / 2.0)}) {
    RobotWithSensors robot;
    robot.laser_place = place;
    const Guarded& answer = robot.drives({0.1, 0.0, 0.0});
    EXPECT_EQ(answer.cause, Cause::WrongView) << answer.reason;
    EXPECT_EQ(answer.factor, 0.0);
  }
}

TEST(Lasers, ALaserUpsideDownSeesTheOtherSide) {
  RobotWithSensors to_the_right, to_the_left;
  Eigen::Matrix<double, 3, 4> place;
  place << 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0.2;
  for (RobotWithSensors* robot : {&to_the_right, &to_the_left}) {
    robot->laser_place = placing_of(place);
    robot->shows_beside_it();
  }
  EXPECT_LT(to_the_right.drives({0.0, -0.5, 0.0}).factor, 1.0);
  EXPECT_EQ(to_the_left.drives({0.0, 0.3, 0.0}).factor, 1.0);
}

Settings with_a_laser(bool inf_is_free = false) {
  Settings settings = guard_settings();
  settings.sensors = {{"laser", InputKind::Scan, "scan", true, {{"inf_is_free", inf_is_free ? 1.0 : 0.0}}}};
  settings.unseen_speed = 0.7;
  return settings;
}

/// A robot with nothing but a laser, at its middle, before a box and beside a wall.
struct RobotBeforeABox : RobotWithSensors {
  explicit RobotBeforeABox(bool inf_is_free = false) : RobotWithSensors(with_a_laser(inf_is_free)) {}

  Pose2 pose;
  bool has_odometry = true;
  float nothing = std::numeric_limits<float>::quiet_NaN();  ///< it says of what it cannot measure
  double box = 1.0;                                         ///< [m] where its front stands, in the resting frame

  /// By this twist, for the period of a look.
  const Guarded& goes(const Twist2& twist) {
    pass(0.05);
    pose = beyond(pose, way_of(twist, 0.05));
    if (has_odometry) control.note_odometry(now.ros, pose, twist);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const double bearing = pose.heading + first_bearing + static_cast<double>(i) * pi / 180.0;
      const double range = (box - pose.place.x) / std::cos(bearing);
      const bool meets = range > 0.0 && std::abs(pose.place.y + range * std::sin(bearing)) < 0.3;
      const double wall = (-1.0 - pose.place.y) / std::sin(bearing);  // at its right side
      const double measured = std::min(meets ? range : 5.0, wall > 0.0 ? wall : 5.0);
      ranges[i] = measured < range_min || measured > range_max ? nothing : static_cast<float>(measured);
    }
    see_scan(0);
    return wants(twist);
  }
  double left() const { return box - pose.place.x - 0.178; }  ///< [m] before its hull
};

/// Some say NaN of what is too near, and some +Inf.
TEST(Lasers, WhatIsNearerThanALaserMeasuresIsKeptWhereItWasSeenLast) {
  for (const double range_min : {0.1, 0.32, 0.36, 0.45, 0.6}) {
    for (const float nothing : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
      for (const bool has_odometry : {true, false}) {
        RobotBeforeABox robot(!std::isnan(nothing));
        robot.range_min = range_min, robot.nothing = nothing, robot.has_odometry = has_odometry;
        double given = 0.0;
        for (int i = 0; i < 400; ++i) {
          robot.goes({given, 0.0, 0.0});
          given = robot.wants({0.3, 0.0, 0.0}).given.linear[0];
        }
        EXPECT_GT(robot.left(), 0.02) << range_min << " " << nothing << " " << has_odometry;
        EXPECT_LT(robot.left(), 0.5) << range_min << " " << nothing << " " << has_odometry;
      }
    }
  }
}

TEST(Lasers, WhatLiesFartherThanALaserMeasuresIsNotSeenToGo) {
  for (const float nothing : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (const bool is_there : {true, false}) {
      RobotBeforeABox robot(!std::isnan(nothing));
      robot.range_max = 1.2, robot.nothing = nothing;
      robot.first_bearing = -pi / 2.0, robot.ranges.resize(180);
      if (!is_there) robot.box = 9.0;
      for (int i = 0; i < 20; ++i) robot.goes({});
      for (int i = 0; i < 80; ++i) robot.goes({-0.1, 0.0, 0.0});
      for (int i = 0; i < 40; ++i) robot.goes({});
      for (int i = 0; i < 40; ++i) robot.goes({0.0, 0.0, pi / 2.0});
      for (int i = 0; i < 80; ++i) robot.goes({-0.2, 0.0, 0.0});
      const Guarded& answer = robot.wants({-0.6, 0.0, 0.0});
      EXPECT_EQ(answer.factor < 0.9, is_there) << nothing << ": " << answer.reason;
    }
  }
}

}  // namespace
}  // namespace safety_control_cloud
