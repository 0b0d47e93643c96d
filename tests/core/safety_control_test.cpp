// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/safety_control.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "cloud_builder.hpp"
#include "malformed_clouds.hpp"

namespace safety_control_cloud {
namespace {

Decision decide_at(double distance, SafetyControl& control, double now = 1.0) {
  const std::vector<Xyz> points = {{0.0f, 0.0f, static_cast<float>(distance)}};
  return control.decide(view_of(points), now);
}

Decision decide_at(double distance) {
  SafetyControl control{Settings{}};
  return decide_at(distance, control);
}

TEST(SafetyControl, RobotDrivesAtFullSpeedWithAnObstacleBeyondOneMetre) {
  const Decision decision = decide_at(1.001);
  EXPECT_EQ(decision.zone, Zone::Safe);
  EXPECT_EQ(decision.speed, 0.2);
  EXPECT_EQ(decision.cause, Cause::Seen);
}

TEST(SafetyControl, RobotSlowsWithAnObstacleAtOneMetreOrNearer) {
  EXPECT_EQ(decide_at(1.0).speed, 0.1);
  EXPECT_EQ(decide_at(0.501).speed, 0.1);
}

TEST(SafetyControl, RobotStandsWithAnObstacleAtHalfAMetreOrNearer) {
  const Decision decision = decide_at(0.5);
  EXPECT_EQ(decision.zone, Zone::Danger);
  EXPECT_EQ(decision.speed, 0.0);
  EXPECT_EQ(decision.nearest->distance(), 0.5);
}

TEST(SafetyControl, RobotDrivesWhenTheCorridorWasSeenToBeFree) {
  const std::vector<Xyz> beside = {{3.0f, 0.0f, 0.4f}};
  const Decision decision = SafetyControl{Settings{}}.decide(view_of(beside), 1.0);
  EXPECT_EQ(decision.zone, Zone::Safe);
  EXPECT_EQ(decision.cause, Cause::Seen);
  EXPECT_FALSE(decision.nearest);
}

TEST(SafetyControl, RobotStandsBeforeTheFirstCloud) {
  const Decision decision = SafetyControl{Settings{}}.without_cloud(100.0);
  EXPECT_EQ(decision.cause, Cause::NoCloud);
  EXPECT_EQ(decision.speed, 0.0);
}

TEST(SafetyControl, LastDecisionHoldsUntilTheSourceTimesOut) {
  SafetyControl control{Settings{}};
  decide_at(2.0, control, 10.0);
  EXPECT_EQ(control.without_cloud(10.5).speed, 0.2);
  const Decision decision = control.without_cloud(10.6);
  EXPECT_EQ(decision.cause, Cause::Silent);
  EXPECT_EQ(decision.zone, Zone::Danger);
  EXPECT_EQ(decision.speed, 0.0);
  EXPECT_FALSE(decision.nearest);
}

TEST(SafetyControl, RobotGoesOnByItselfWhenTheCameraIsBack) {
  SafetyControl control{Settings{}};
  decide_at(2.0, control, 10.0);
  control.without_cloud(20.0);
  EXPECT_EQ(decide_at(2.0, control, 20.1).speed, 0.2);
}

TEST(SafetyControl, RobotStandsWhenNothingReturns) {
  for (const auto& points : {std::vector<Xyz>{}, {{nan, nan, nan}}, {{0, 0, 0}}, {{0, 0, inf}, {nan, 0, 1}}}) {
    SafetyControl control{Settings{}};
    decide_at(2.0, control);
    const Decision decision = control.decide(view_of(points), 1.1);
    EXPECT_EQ(decision.cause, Cause::Blind);
    EXPECT_EQ(decision.zone, Zone::Danger);
    EXPECT_EQ(decision.speed, 0.0);
  }
}

TEST(SafetyControl, RobotStandsWhenTooLittleReturnsToTellFreeFromBlind) {
  std::vector<Xyz> points(100, Xyz{nan, nan, nan});
  std::fill_n(points.begin(), 9, Xyz{0.0f, 0.0f, 3.0f});
  EXPECT_EQ(SafetyControl{Settings{}}.decide(view_of(points), 1.0).cause, Cause::Blind);
  points[9] = points[0];
  EXPECT_EQ(SafetyControl{Settings{}}.decide(view_of(points), 1.0).cause, Cause::Seen);
}

TEST(SafetyControl, RobotStandsForEveryMalformedCloud) {
  for (const auto& malformed : malformed_clouds()) {
    SafetyControl control{Settings{}};
    decide_at(2.0, control);
    const auto [layout, size] = malformed.cloud();
    const std::vector<std::uint8_t> bytes(size);
    const Decision decision = control.decide(view_of(layout, bytes.data(), bytes.size()), 1.1);
    EXPECT_EQ(decision.cause, Cause::Unreadable) << malformed.name;
    EXPECT_EQ(decision.speed, 0.0) << malformed.name;
    EXPECT_FALSE(decision.reason.empty()) << malformed.name;
  }
}

TEST(SafetyControl, UnreadableCloudKeepsTheCameraFromCountingAsSilent) {
  SafetyControl control{Settings{}};
  control.decide(Unreadable{"no field x"}, 5.0);
  EXPECT_EQ(control.without_cloud(5.4).cause, Cause::Unreadable);
}

TEST(SafetyControl, RobotWaitsOutTheHoldBeforeItBelievesABetterZone) {
  Settings settings;
  settings.release.clouds = 3;
  SafetyControl control{settings};
  EXPECT_EQ(decide_at(2.0, control, 1.0).speed, 0.0);
  EXPECT_EQ(decide_at(2.0, control, 1.1).speed, 0.0);
  EXPECT_EQ(decide_at(2.0, control, 1.2).speed, 0.2);
  EXPECT_EQ(decide_at(0.4, control, 1.3).speed, 0.0) << "worse at once";
}

TEST(SafetyControl, UnfitSettingsAreRefusedWithEveryProblem) {
  Settings settings;
  settings.limits.danger = 2.0;
  settings.publish_rate = 0.0;
  try {
    SafetyControl control{settings};
    FAIL() << "drives with unfit settings";
  } catch (const std::invalid_argument& refusal) {
    const std::string text = refusal.what();
    EXPECT_NE(text.find("warning_distance"), std::string::npos) << text;
    EXPECT_NE(text.find("publish_rate"), std::string::npos) << text;
  }
}

TEST(SafetyControl, BothMethodsDecideTheSame) {
  for (const double distance : {0.4, 0.5, 0.7, 1.0, 3.0}) {
    Settings by_pcl;
    by_pcl.method = Method::Pcl;
    SafetyControl control{by_pcl};
    EXPECT_EQ(decide_at(distance, control).zone, decide_at(distance).zone) << distance;
  }
}

}  // namespace
}  // namespace safety_control_cloud
