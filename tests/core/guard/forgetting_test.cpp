// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/forgetting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robot_with_odometry.hpp"
#include "robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

const Twist2 right{0.0, -0.5, 0.0};

/// Whatever returned around where it may be would show it: it would never be forgotten, and be anywhere by then.
TEST(Forgetting, AWallFarBehindAThingThatHasGoneKeepsNothingWhosePlaceNobodyKnows) {
  for (const double drift : {0.02, 0.3}) {
    Settings settings = remembering(1.0);
    settings.odometry_drift = drift;
    RobotWithOdometry robot(settings);
    robot.passes(0.5, with_post);
    for (const double angle : {quarter, -quarter}) robot.turns(angle, robot.hall);
    robot.passes(40.0, Scene({wall_before(1.6f)}));
    robot.turns(quarter, robot.hall);
    EXPECT_EQ(robot.asked({0.0, -0.5, 0.0}).factor, 1.0) << drift << ": " << robot.wants({0.0, -0.5, 0.0}).reason;
  }
}

/// The front of a board, that may lie nearer by now and below the picture: what returns in its place may be the rest.
TEST(Forgetting, WhatReturnsFromAPlaceThatIsNotWellKnownIsNotAllOfIt) {
  const auto factor_of = [](bool has_turned) {
    Settings settings = remembering();
    settings.odometry_drift = 0.1;
    RobotWithOdometry robot(settings);
    const Scene board({{0.59f, -0.05f, 0.05f, 0.17f, floor_y}});
    robot.passes(0.5, board);
    if (has_turned) {
      for (const double angle : {quarter, -quarter}) robot.turns(angle, robot.hall);
      robot.passes(0.5, board);
    }
    robot.turns(quarter, robot.hall);
    return robot.asked({0.0, -0.3, 0.0}).factor;
  };
  EXPECT_LT(factor_of(true), 0.9 * factor_of(false));
}

/// Shown as it goes, too far away to be kept anew, and for longer than anything is kept.
TEST(Forgetting, WhatIsSeenFartherAwayThanTheMemoryReachesHasNotGone) {
  for (const float away : {0.0f, 0.2f, 0.8f}) {
    RobotWithOdometry robot(remembering(1.0));
    robot.passes(0.5, with_post);
    const int steps = static_cast<int>(std::lround(away / 0.01f));
    robot.twist = {-0.2, 0.0, 0.0};
    for (int i = 1; i <= steps; ++i) {
      robot.pose.place.x -= 0.01;
      robot.passes(0.05, Scene({post(0.9f + 0.01f * static_cast<float>(i), 0.0f)}));
    }
    robot.twist = {};
    robot.passes(40.0, Scene({post(0.9f + away, 0.0f)}));
    robot.turns(quarter, robot.hall);
    robot.twist = {0.0, -0.2, 0.0};
    for (int i = 0; i < steps; ++i) {
      robot.pose.place.x += 0.01;
      robot.passes(0.05, robot.hall);
    }
    robot.twist = {};
    const Guarded& answer = robot.asked({0.0, -0.7, 0.0});
    EXPECT_LT(answer.factor, 0.95) << away << ": " << answer.reason;
    EXPECT_EQ(answer.sensor, "memory");
  }
}

/// A gripper before the camera, and a post that is seen beside it and then, once the robot has turned, behind it.
TEST(Forgetting, WhatAPartOfTheRobotHidesHasNotGone) {
  for (const float width : {0.1f, 0.2f}) {
    Settings settings = remembering();
    settings.self_boxes.text = "[[0.33, 0.39, -0.15, 0.15, 0.0, 1.0]]";
    RobotWithOdometry robot(settings);
    const Board gripper{0.46f, -width / 2, width / 2, -0.2f, 0.2f};
    const Scene before({gripper, post(0.48f, 0.18f)}), after({gripper});
    robot.passes(0.5, before);
    robot.turns(-std::atan2(0.18, 0.393), after);
    robot.passes(1.0, after);
    const Guarded& answer = robot.wants({0.6, 0.0, 0.0});
    EXPECT_LT(answer.factor, 0.95) << width << ": " << answer.reason;
    EXPECT_EQ(answer.sensor, "memory");
    RobotWithOdometry alone(settings);
    alone.passes(1.0, after);
    EXPECT_EQ(alone.wants({0.6, 0.0, 0.0}).factor, 1.0) << "itself it does not stop for";
  }
}

/// What a late camera saw before it came, or came back, tells nothing of what a laser has shown since.
TEST(Forgetting, WhatWasSeenBeforeItCameDoesNotMakeItGo) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  const Board wall = wall_before(2.0);
  const Scene empty({wall}), board({{0.56f + 0.087f, -0.1f, 0.1f, -0.1f, 0.2f}, wall});
  for (const double late : {0.25, 0.4}) {
    for (const bool was_there_before : {false, true}) {
      RobotWithSensors robot;
      robot.rear_shows = robot.front_shows = false;
      robot.stamp_behind = late;
      const double came = robot.now.ros + 1.0;
      const auto shows_ahead = [&](float range, double seconds) {
        for (std::size_t degrees = 170; degrees <= 190; ++degrees) robot.ranges[degrees] = range;
        for (double t = 0.0; t < seconds - 0.01; t += 0.05) {
          robot.pass(0.05);
          robot.control.note_odometry(robot.now.ros, {}, {});
          const double before = came - (robot.now.ros - late);  // [s] that the camera looked
          robot.see((was_there_before && before > 0.12 && before < 0.22 ? board : empty).view());
          robot.see_scan();
          robot.wants({});
        }
      };
      shows_ahead(5.0f, 1.0);
      shows_ahead(0.56f, 0.1);
      shows_ahead(infinite, late - 0.1);  // nearer than it measures
      const Guarded& answer = robot.wants({0.6, 0.0, 0.0});
      EXPECT_LT(answer.factor, 0.8) << late << ": " << answer.reason;
      EXPECT_EQ(answer.sensor, "memory") << late << ": " << answer.reason;
    }
  }
}

TEST(Forgetting, WhatIsSeenThroughIsForgotten) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.turns(-quarter, robot.hall);
  robot.passes(0.2, Scene({wall_before(1.5)}));
  robot.turns(quarter, robot.hall);
  EXPECT_EQ(robot.asked({0.0, -0.5, 0.0}).factor, 1.0) << robot.wants(right).reason;
}

/// Beyond the camera's range nothing returns from behind it.
TEST(Forgetting, WhereNothingReturnsAnyMoreItIsForgottenAfterAWhile) {
  for (const double seconds : {0.5, 2.0}) {
    RobotWithOdometry robot;
    robot.passes(0.5, with_post);
    robot.passes(seconds, robot.hall);
    robot.turns(quarter, robot.hall);
    EXPECT_EQ(robot.asked({0.0, -0.7, 0.0}).factor < 1.0, seconds < 1.0) << robot.wants(right).reason;
  }
}

TEST(Forgetting, ASensorThatLooksElsewhereKeepsNothing) {
  for (const double seconds : {0.5, 2.0}) {
    Settings settings = remembering();
    settings.sensors = {{"front", InputKind::Cloud, "front/points", true, {}},
                        {"rear", InputKind::Cloud, "rear/points", false, {}}};
    RobotWithOdometry robot(settings);
    const auto passes = [&](double time, const Scene& scene) {
      for (double t = 0.0; t < time; t += 0.05) {
        robot.passes(0.05, scene);
        robot.see(robot.hall.view(), turned_xtion(pi), rear);
      }
    };
    passes(0.5, with_post);
    passes(seconds, robot.hall);
    robot.turns(quarter, robot.hall);
    EXPECT_EQ(robot.asked({0.0, -0.7, 0.0}).factor < 1.0, seconds < 1.0) << robot.wants(right).reason;
  }
}

/// It may lie beside where it is looked for, outside the picture.
TEST(Forgetting, WhereOdometryMayHaveDriftedALookPastAPlaceProvesTheLess) {
  const double aside = 0.4;  // [rad]
  for (const double drift : {0.0, 0.05}) {
    Settings settings = remembering();
    settings.odometry_drift = drift;
    RobotWithOdometry robot(settings);
    robot.passes(0.5, with_post);
    const Scene wall({wall_before(1.5)});
    for (int i = 0; i < 3; ++i) robot.turns(quarter, robot.hall);
    robot.turns(quarter - aside, wall);
    robot.passes(1.0, wall);
    const Twist2 there{0.6 * std::cos(aside), 0.6 * std::sin(aside), 0.0};
    EXPECT_EQ((robot.wants(there).factor < 1.0), (drift > 0.0)) << robot.wants(there).reason;
  }
}

}  // namespace
}  // namespace safety_control_cloud
