// SPDX-License-Identifier: BSD-3-Clause
// What a laser shows and a camera does not: a glass door, a black leg, or whatever stands not quite where TF has it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr double half_width = 0.06;  ///< [m] of a post ahead

enum class Camera { Sees, SeesThrough, GetsNothing };

Settings with_camera_and_laser() {
  Settings settings = guard_settings();
  settings.sensors = {{"front", InputKind::Cloud, "front/points", true, {}},
                      {"laser", InputKind::Scan, "scan", true, {}}};
  return settings;
}

/// Before a post that hides no near floor, a laser that does not measure what is near, and a camera; odometry is right.
struct RobotBeforeAPost : RobotWithSensors {
  explicit RobotBeforeAPost(Camera camera) : RobotWithSensors(with_camera_and_laser()), camera(camera) {
    range_min = 0.5;
  }

  Camera camera;
  double missing = 0.0;  ///< share of the scans that measure nothing of the post
  std::mt19937 random{1};
  Pose2 pose;
  double post = 1.0;  ///< [m] where its front stands, in the resting frame
  int looks = 0;

  double ahead() const { return post - pose.place.x; }  ///< [m]
  double left() const { return ahead() - 0.178; }       ///< [m] before its hull

  void goes(const Twist2& twist) {
    pass(0.05);
    pose = beyond(pose, way_of(twist, 0.05));
    control.note_odometry(now.ros, pose, twist);
    see(picture().view(), xtion(), 0);
    if (++looks % 2 != 0) return;
    const bool is_missed = std::uniform_real_distribution<double>(0.0, 1.0)(random) < missing;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const double bearing = pose.heading + first_bearing + static_cast<double>(i) * pi / 180.0;
      const double range = ahead() / std::cos(bearing);
      const bool meets = ahead() > 0.0 && range > 0.0 && std::abs(range * std::sin(bearing)) < half_width;
      ranges[i] = !meets ? 5.0f : range < range_min || is_missed ? nan : static_cast<float>(range);
    }
    see_scan(1);
  }

  /// A wall, and before it the post, if the camera sees it; turned aside, it sees neither.
  Scene picture() const {
    const auto across = static_cast<float>(half_width), z = static_cast<float>(ahead() + 0.087);
    const Board wall{4.0f, -9.0f, 9.0f, -9.0f, floor_y}, seen{z, -across, across, -1.0f, 0.12f};
    if (std::abs(pose.heading) > 0.1 || ahead() > 3.0) return Scene({wall});
    if (camera == Camera::Sees) return Scene({wall, seen});
    Scene scene({wall});
    if (camera == Camera::SeesThrough) return scene;
    const Scene with_post({wall, seen});
    for (std::size_t i = 0; i < Scene::width * Scene::height; ++i) {
      const std::size_t row = i / Scene::width, column = i % Scene::width;
      const float z_of_post = z_in(with_post, row, column);
      if (std::isnan(z_of_post) || z_of_post < z + 0.01f) scene.set(row, column, nan);
    }
    return scene;
  }

  static float z_in(const Scene& scene, std::size_t row, std::size_t column) {
    Xyz point;
    std::memcpy(&point, scene.view().bytes + (row * Scene::width + column) * sizeof point, sizeof point);
    return point.z;
  }
};

TEST(DisagreeingSensors, WhatACameraNeverSawIsNotSeenToGo) {
  for (const Camera camera : {Camera::Sees, Camera::SeesThrough, Camera::GetsNothing}) {
    for (const double speed : {0.15, 0.4}) {
      RobotBeforeAPost robot(camera);
      double given = 0.0, least = 1.0;
      for (int i = 0; i < 300; ++i) {
        robot.goes({given, 0.0, 0.0});
        given = robot.wants({speed, 0.0, 0.0}).given.linear[0];
        least = std::min(least, robot.left());
      }
      EXPECT_GT(least, 0.02) << static_cast<int>(camera) << ", " << speed;
      EXPECT_LT(robot.ahead(), robot.range_min) << static_cast<int>(camera) << ", " << speed;
    }
  }
}

/// A laser does not measure all that is black, or glass, in each turn.
TEST(DisagreeingSensors, ThatALaserMeasuresNothingNowAndThenSaysNothing) {
  for (const Camera camera : {Camera::SeesThrough, Camera::GetsNothing}) {
    for (const double missing : {0.3, 0.7}) {
      RobotBeforeAPost robot(camera);
      robot.missing = missing;
      double given = 0.0, least = 1.0;
      for (int i = 0; i < 300; ++i) {
        robot.goes({given, 0.0, 0.0});
        given = robot.wants({0.3, 0.0, 0.0}).given.linear[0];
        least = std::min(least, robot.left());
      }
      EXPECT_GT(least, 0.02) << static_cast<int>(camera) << ", " << missing;
    }
  }
}

TEST(DisagreeingSensors, WhatAnotherProcessKeptIsNotSeenToGoByWhoMayNotSeeIt) {
  RobotBeforeAPost robot(Camera::SeesThrough), next(Camera::SeesThrough);
  double given = 0.0;
  for (int i = 0; i < 300; ++i) {
    robot.goes({given, 0.0, 0.0});
    given = robot.wants({0.3, 0.0, 0.0}).given.linear[0];
  }
  next.now = robot.now, next.pose = robot.pose;
  ASSERT_TRUE(next.control.recall(robot.control.remembered()));
  double least = 1.0;
  given = 0.0;
  for (int i = 0; i < 200; ++i) {
    next.goes({given, 0.0, 0.0});
    given = next.wants({0.3, 0.0, 0.0}).given.linear[0];
    least = std::min(least, next.left());
  }
  EXPECT_GT(least, 0.02);
}

/// What has really gone while both look is free as soon as the laser says so.
TEST(DisagreeingSensors, WhatGoesIsFree) {
  for (const Camera camera : {Camera::Sees, Camera::SeesThrough}) {
    RobotBeforeAPost robot(camera);
    robot.post = 0.6;
    for (int i = 0; i < 20; ++i) robot.goes({});
    EXPECT_LT(robot.wants({0.6, 0.0, 0.0}).factor, 0.9);
    robot.post = 9.0;
    for (int i = 0; i < 10; ++i) robot.goes({});
    EXPECT_EQ(robot.wants({0.6, 0.0, 0.0}).factor, 1.0) << static_cast<int>(camera);
  }
}

/// Who has not looked there meanwhile may be right: the post was taken away while nobody saw it.
TEST(DisagreeingSensors, ACameraThatHadNotLookedThereIsBelieved) {
  RobotBeforeAPost robot(Camera::Sees);
  robot.post = 0.55;
  robot.front_shows = false;
  const auto scans = [&](int times) {
    for (int i = 0; i < times; ++i) {
      robot.pass(0.05);
      robot.control.note_odometry(robot.now.ros, robot.pose, {});
      for (std::size_t degrees = 174; degrees <= 186; ++degrees)
        robot.ranges[degrees] = robot.ahead() > 3.0 ? 5.0f : robot.ahead() < robot.range_min ? nan : 0.55f;
      robot.see_scan(1);
    }
  };
  scans(20);
  robot.pose.place.x = 0.1;  // nearer than the laser measures
  scans(4);
  robot.post = 9.0;
  robot.range_min = 5.5;  // it measures nothing any more
  std::fill(robot.ranges.begin(), robot.ranges.end(), nan);
  for (int i = 0; i < 40; ++i) {
    robot.pass(0.05);
    robot.control.note_odometry(robot.now.ros, robot.pose, {});
    robot.see(robot.picture().view(), xtion(), 0);
    robot.see_scan(1);
  }
  const Guarded& answer = robot.wants({0.3, 0.0, 0.0});
  EXPECT_NE(answer.sensor, "memory") << answer.reason;
}

}  // namespace
}  // namespace safety_control_cloud
