// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "../../safety_control_cloud/core/perception.hpp"
#include "guard/robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

TEST(Perception, WhatAllSeeToBeFreePassesInEveryDirection) {
  RobotWithSensors robot;
  for (const Twist2& twist :
       {Twist2{0.5, 0.0, 0.0}, Twist2{-0.4, 0.0, 0.0}, Twist2{0.3, 0.0, 0.8}, Twist2{0.0, 0.3, 0.0}}) {
    const Guarded& answer = robot.drives(twist);
    EXPECT_EQ(answer.factor, 1.0) << twist.vx << " " << twist.vy << " " << twist.w << ": " << answer.reason;
  }
}

TEST(Perception, TheOneThatSeesAnObstacleDecidesAndIsNamed) {
  RobotWithSensors robot;
  robot.behind = Scene({wall_before(0.3)});
  EXPECT_EQ(robot.drives({0.5, 0.0, 0.0}).factor, 1.0) << robot.drives({0.5, 0.0, 0.0}).reason;
  const Guarded& back = robot.drives({-0.6, 0.0, 0.0});
  EXPECT_LT(back.factor, 1.0);
  EXPECT_EQ(back.sensor, "rear");
  ASSERT_TRUE(back.point);
  EXPECT_NEAR(back.point->x, -0.478, 0.05);
}

TEST(Perception, OneThatIsRequiredAndInDoubtStopsEveryMotion) {
  for (const std::size_t lost : {front, laser}) {
    RobotWithSensors robot;
    ASSERT_EQ(robot.drives({0.3, 0.0, 0.0}).factor, 1.0);
    (lost == front ? robot.front_shows : robot.laser_shows) = false;
    robot.pass(0.2);
    robot.drives({0.3, 0.0, 0.0});
    for (const Twist2& twist : {Twist2{0.3, 0.0, 0.0}, Twist2{-0.1, 0.0, 0.0}, Twist2{0.0, 0.0, 0.5}}) {
      const Guarded& answer = robot.drives(twist);
      EXPECT_EQ(answer.cause, Cause::Silent) << answer.reason;
      EXPECT_EQ(answer.factor, 0.0);
      EXPECT_EQ(answer.sensor, lost == front ? "front" : "laser");
    }
    (lost == front ? robot.front_shows : robot.laser_shows) = true;
    EXPECT_EQ(robot.drives({0.3, 0.0, 0.0}).factor, 1.0) << "and it recovers";
  }
}

TEST(Perception, OneThatIsNotRequiredOnlyStopsToCountAsHavingSeen) {
  RobotWithSensors robot(with_sensors(false));
  ASSERT_EQ(robot.drives({-0.3, 0.0, 0.0}).factor, 1.0);
  robot.rear_shows = robot.laser_shows = false;
  robot.drives({-0.3, 0.0, 0.0});
  const Guarded& back = robot.drives({-0.3, 0.0, 0.0});
  EXPECT_NEAR(back.given.linear[0], -0.1, 1e-9) << "nobody looks there: unseen_speed";
  ASSERT_EQ(back.doubts.size(), std::size_t{2});
  EXPECT_NE(back.doubts[0].find("rear: SILENT"), std::string::npos) << back.doubts[0];
  EXPECT_EQ(robot.drives({0.3, 0.0, 0.0}).factor, 1.0);
  EXPECT_TRUE((robot.rear_shows = robot.laser_shows = true, robot.drives({-0.3, 0.0, 0.0})).doubts.empty());
}

TEST(Perception, WithoutAnyThatIsRequiredAndNoneToBelieveItStands) {
  Settings settings = with_sensors(false);
  settings.sensors[front].required = false;
  RobotWithSensors robot(settings);
  ASSERT_EQ(robot.drives({0.3, 0.0, 0.0}).factor, 1.0);
  robot.front_shows = robot.rear_shows = robot.laser_shows = false;
  robot.drives({0.3, 0.0, 0.0});
  EXPECT_EQ(robot.drives({0.3, 0.0, 0.0}).factor, 0.0);
  EXPECT_EQ(robot.drives({-0.05, 0.0, 0.0}).factor, 0.0);
}

/// Each camera keeps what came near along its own way of looking.
TEST(Perception, WhatARearCameraLostClosesTheWayBack) {
  RobotWithSensors robot;
  robot.laser_shows = true;
  robot.behind = Scene({post(0.6f, 0.0f)});
  robot.drives({0.1, 0.0, 0.0});
  robot.behind = Scene({post(0.35f, 0.0f)});  // nearer than the camera can see
  const Guarded& back = robot.drives({-0.1, 0.0, 0.0});
  EXPECT_EQ(back.factor, 0.0) << back.reason;
  EXPECT_EQ(back.cause, Cause::NearLoss) << back.reason;
  EXPECT_EQ(back.sensor, "rear");
  EXPECT_EQ(robot.drives({0.5, 0.0, 0.0}).factor, 1.0) << "the front camera looks there: " << back.reason;
}

TEST(Perception, ACameraThatLooksUpIsNoSight) {
  Settings settings = guard_settings();
  settings.sensors = {{"up", InputKind::Cloud, "up/points", true, {}}};
  GuardedRobot robot(settings);
  Eigen::Matrix<double, 3, 4> place;
  place << 0, -1, 0, 0, -1, 0, 0, 0.0, 0, 0, 1, 0.2972;
  const Scene scene;
  for (int i = 0; i < 10; ++i) {
    robot.pass(0.05);
    robot.see(scene.view(), placing_of(place));
    EXPECT_EQ(robot.wants({0.05, 0.0, 0.0}).factor, 0.0);
  }
  EXPECT_EQ(robot.wants({0.05, 0.0, 0.0}).cause, Cause::WrongView) << robot.wants({0.05, 0.0, 0.0}).reason;
}

TEST(Perception, WhatEachRemembersOutlivesTheProcess) {
  RobotWithSensors before;
  before.behind = Scene({post(0.6f, 0.0f)});
  before.drives({0.1, 0.0, 0.0});
  const auto remembered = before.control.remembered();
  ASSERT_EQ(remembered.size(), std::size_t{4});
  EXPECT_TRUE(remembered[front].empty());
  EXPECT_FALSE(remembered[rear].empty());
  RobotWithSensors after;
  ASSERT_TRUE(after.control.recall(remembered));
  after.behind = Scene({post(0.35f, 0.0f)});
  EXPECT_EQ(after.drives({-0.1, 0.0, 0.0}).factor, 0.0);
  Settings other_order = with_sensors(), without_rear = with_sensors();
  std::swap(other_order.sensors[front], other_order.sensors[rear]);
  without_rear.sensors.erase(without_rear.sensors.begin() + rear);
  GuardControl other(other_order);
  ASSERT_TRUE(other.recall(remembered));
  EXPECT_EQ(other.remembered()[front], remembered[rear]) << "each is known by its name";
  EXPECT_FALSE(GuardControl(without_rear).recall(remembered));
}

TEST(Perception, TheSoonestToBeSilentIsTold) {
  Settings settings = with_sensors();
  settings.sensors[laser].own["source_timeout"] = 0.2;
  RobotWithSensors robot(settings);
  EXPECT_TRUE(std::isinf(robot.control.until_silent(robot.now.steady)));
  robot.drives({0.1, 0.0, 0.0});
  EXPECT_NEAR(robot.control.until_silent(robot.now.steady), 0.2, 1e-9);
  robot.pass(0.3);
  EXPECT_NEAR(robot.control.until_silent(robot.now.steady), 0.2, 1e-9) << "the cameras', the laser is";
  EXPECT_EQ(robot.wants({0.1, 0.0, 0.0}).cause, Cause::Silent);
}

TEST(Perception, AnAnswerIsDueBeforeTheFastestWouldLookAgain) {
  Settings settings = with_sensors();
  settings.publish_rate = 5.0;
  settings.stopping.sensor_period = 0.1;
  EXPECT_NEAR(RobotWithSensors(settings).control.answer_period(), 0.1, 1e-9);
  settings.sensors[rear].own["sensor_period"] = 0.03;
  EXPECT_NEAR(RobotWithSensors(settings).control.answer_period(), 0.03, 1e-9);
  settings.sensors[rear].own["sensor_period"] = 0.3;
  EXPECT_NEAR(RobotWithSensors(settings).control.answer_period(), 0.1, 1e-9);
  settings.publish_rate = 20.0;
  EXPECT_NEAR(RobotWithSensors(settings).control.answer_period(), 0.05, 1e-9);
  settings.sensors[rear].own["sensor_period"] = 0.0;
  EXPECT_NEAR(RobotWithSensors(settings).control.answer_period(), 0.01, 1e-9) << "no more than a hundred a second";
}

/// It looks seldom, and nobody requires it; what it showed is not forgotten for a change of something else.
TEST(Perception, AfterALiveChangeOneThatIsNotRequiredIsWaitedForToo) {
  Settings settings = with_sensors();
  settings.memory_distance = 0.0;
  RobotWithSensors robot(settings);
  robot.behind = Scene({post(0.45f, 0.0f)});
  ASSERT_LT(robot.drives({-0.5, 0.0, 0.0}).factor, 0.8);
  settings.noise = 0.011;
  robot.control.adopt(settings);
  robot.rear_shows = false;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(robot.drives_on({-0.2, 0.0, 0.0}).factor, 0.0) << i;
  EXPECT_EQ(robot.wants({-0.2, 0.0, 0.0}).cause, Cause::NoCloud);
  for (int i = 0; i < 20; ++i) robot.drives_on({-0.2, 0.0, 0.0});
  EXPECT_GT(robot.wants({-0.2, 0.0, 0.0}).factor, 0.0) << "silent by now, it is as good as not there";
}

TEST(Perception, ALiveChangeHoldsForAllAndLeavesEachItsOwn) {
  RobotWithSensors robot;
  ASSERT_EQ(robot.drives({0.5, 0.0, 0.0}).factor, 1.0);
  Settings changed = with_sensors();
  changed.max_speed = 0.25;
  robot.control.adopt(changed);
  EXPECT_NEAR(robot.drives({0.5, 0.0, 0.0}).given.linear[0], 0.25, 1e-9);
}

}  // namespace
}  // namespace safety_control_cloud
