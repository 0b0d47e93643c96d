// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/unplaced.hpp"

#include <gtest/gtest.h>

#include "guard/robot_with_odometry.hpp"
#include "guard/robot_with_sensors.hpp"
#include "memory/looking_robot.hpp"

namespace safety_control_cloud {
namespace {

using Texts = std::vector<std::string>;

const Board near_board = {0.45f, -0.2f, 0.2f, -0.2f, 0.05f}, passed = {0.35f, -0.2f, 0.2f, -0.2f, 0.05f};
const Board wall = {2.0f, -3.0f, 3.0f, -3.0f, floor_y};
const Scene free_hall({wall}), with_passed({passed, wall});
constexpr Twist2 ahead = {0.1, 0.0, 0.0}, back = {-0.1, 0.0, 0.0};

template <class AnyRobot>
AnyRobot that_lost_a_board(AnyRobot robot, void (*show)(AnyRobot&, const Scene&)) {
  for (int i = 0; i < 5; ++i) show(robot, Scene({near_board, wall}));
  for (int i = 0; i < 3; ++i) show(robot, with_passed);
  return robot;
}

Texts lost_in_mode_drive() {
  return that_lost_a_board<Robot>(Robot(), [](Robot& robot, const Scene& scene) { robot.sees(scene); })
      .control()
      .remembered();
}

Texts lost_as_a_guard() {
  const auto show = [](GuardedRobot& robot, const Scene& scene) { robot.drives_on(scene, ahead); };
  return that_lost_a_board<GuardedRobot>(GuardedRobot(), show).control.remembered();
}

Settings of_one_sensor(InputKind type) {
  Settings settings = guard_settings();
  settings.sensors = {{"front", type, "front/points", true, {}}};
  return settings;
}

TEST(Unplaced, AGuardStandsForWhatWasLostInModeDriveUntilItIsSeenToHaveGone) {
  GuardedRobot guard;
  ASSERT_TRUE(guard.control.recall(lost_in_mode_drive()));
  EXPECT_EQ(guard.drives(with_passed, ahead).cause, Cause::NearLoss);
  EXPECT_EQ(guard.wants(ahead).factor, 0.0);
  EXPECT_EQ(guard.drives(free_hall, ahead).factor, 1.0) << guard.wants(ahead).reason;
}

TEST(Unplaced, ModeDriveStandsForWhatAGuardLostUntilItIsSeenToHaveGone) {
  Robot robot;
  ASSERT_TRUE(robot.control().recall(lost_as_a_guard()));
  for (int i = 0; i < 20; ++i) ASSERT_EQ(robot.sees(with_passed).cause, Cause::NearLoss);
  EXPECT_EQ(robot.sees(with_passed).speed, 0.0);
  for (int i = 0; i < 40; ++i) robot.sees(free_hall);
  EXPECT_EQ(robot.sees(free_hall).speed, 0.2);
}

TEST(Unplaced, WhatACameraLostThatBearsAnotherNameByNowStopsEveryMotionUntilReset) {
  for (const InputKind type : {InputKind::Cloud, InputKind::Scan}) {
    GuardedRobot guard(of_one_sensor(type));
    EXPECT_FALSE(guard.control.recall(lost_as_a_guard()));
    if (type == InputKind::Scan) continue;
    for (const Twist2& twist : {ahead, back}) {
      const Guarded& answer = guard.drives(free_hall, twist);
      EXPECT_EQ(answer.factor, 0.0);
      EXPECT_EQ(answer.cause, Cause::NearLoss) << answer.reason;
      EXPECT_EQ(answer.reason, "what was near or lost before this start cannot be placed");
      EXPECT_NE(answer.hint.find("~reset"), std::string::npos) << answer.hint;
      EXPECT_TRUE(answer.stuck);
    }
    guard.control.forget_losses();
    EXPECT_EQ(guard.drives(free_hall, ahead).factor, 1.0) << guard.wants(ahead).reason;
    EXPECT_EQ(guard.control.remembered(), Texts(2)) << "and the next one drives";
  }
}

TEST(Unplaced, WhatASensorLostThatIsNoCameraAnyMoreCannotBePlaced) {
  Settings settings = guard_settings();
  settings.input = InputKind::Scan;
  EXPECT_FALSE(GuardControl(settings).recall(lost_as_a_guard()));
  RobotWithSensors before;
  before.behind = Scene({near_board});
  before.drives({0.1, 0.0, 0.0});
  Settings changed = with_sensors();
  changed.sensors[rear].type = InputKind::Scan;
  EXPECT_FALSE(GuardControl(changed).recall(before.control.remembered()));
}

TEST(Unplaced, ModeDriveStandsForWhatSeveralSensorsLostUntilReset) {
  RobotWithSensors guard;
  guard.behind = Scene({near_board});
  guard.drives({0.1, 0.0, 0.0});
  const Texts remembered = guard.control.remembered();
  Robot robot;
  EXPECT_FALSE(robot.control().recall(remembered));
  Decision decision = robot.sees(free_hall);
  for (int i = 0; i < 40; ++i) decision = robot.sees(free_hall);
  EXPECT_EQ(decision.cause, Cause::NearLoss);
  EXPECT_EQ(decision.speed, 0.0);
  EXPECT_EQ(decision.stuck_since, 100.05);
  EXPECT_NE(decision.hint.find("~reset"), std::string::npos);
  RobotWithSensors next;
  ASSERT_TRUE(next.control.recall(robot.control().remembered())) << "it was kept for the one who knows its place";
  next.behind = with_passed;
  EXPECT_EQ(next.drives(back).cause, Cause::NearLoss);
  robot.control().forget_losses();
  for (int i = 0; i < 40; ++i) decision = robot.sees(free_hall);
  EXPECT_EQ(decision.speed, 0.2);
}

TEST(Unplaced, WhatSpeaksAgainstTheCameraIsToldBeforeIt) {
  Robot robot;
  robot.control().recall({"places-9 of another version"});
  EXPECT_EQ(robot.sees(free_hall).cause, Cause::NearLoss);
  EXPECT_EQ(robot.sees(Scene({{0.1f, -9.0f, 9.0f, -9.0f, 9.0f}})).cause, Cause::Blind);
}

TEST(Unplaced, WhatWasWrittenInAnotherWayStopsTheRobotToo) {
  for (const char* text : {"things-2 1 2 3", "nonsense", "cloud\nthings-4 160 120 0 0 0 end"}) {
    GuardedRobot guard;
    EXPECT_FALSE(guard.control.recall({text, ""}));
    EXPECT_EQ(guard.drives(free_hall, ahead).cause, Cause::NearLoss) << text;
    Robot robot;
    EXPECT_FALSE(robot.control().recall({text}));
    EXPECT_EQ(robot.sees(free_hall).cause, Cause::NearLoss) << text;
  }
}

TEST(Unplaced, NothingIsNeverUnplaced) {
  for (const Texts& nothing : {Texts{}, Texts{""}, Texts(9)}) {
    EXPECT_TRUE(SafetyControl(Settings{}).recall(nothing));
    EXPECT_TRUE(GuardControl(guard_settings()).recall(nothing));
  }
}

/// A guard that has turned away from a post.
Texts kept_around_a_guard() {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.passes(0.5, robot.hall);
  return robot.control.remembered();
}

Cause cause_in_mode_drive(double ros, const Settings& settings = {}) {
  SafetyControl control(settings);
  EXPECT_FALSE(control.recall(kept_around_a_guard()));
  return control.decide(free_hall.view(), {ros, OpticalFrame{}}, {5.0, ros}).cause;
}

TEST(Unplaced, ModeDriveStandsForWhatAGuardKeptAroundTheRobotForAsLongAsThatWould) {
  EXPECT_EQ(cause_in_mode_drive(1010.0), Cause::NearLoss);
  EXPECT_EQ(cause_in_mode_drive(1100.0), Cause::Seen) << "memory_time is over";
  Settings keeps_none;
  keeps_none.memory_distance = 0.0;
  EXPECT_EQ(cause_in_mode_drive(1010.0, keeps_none), Cause::Seen);
}

TEST(Unplaced, NearLossTimeoutFreesIt) {
  Settings settings;
  settings.near_loss.timeout = 10.0;
  Robot robot(settings);
  robot.control().recall({"nonsense"});
  EXPECT_EQ(robot.sees(free_hall).cause, Cause::NearLoss);
  robot.waits(9.9);
  EXPECT_EQ(robot.sees(free_hall).cause, Cause::NearLoss);
  robot.waits(0.2);
  EXPECT_EQ(robot.sees(free_hall).cause, Cause::Seen);
}

}  // namespace
}  // namespace safety_control_cloud
