// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/safety_control.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "input/cloud_builder.hpp"
#include "input/malformed_clouds.hpp"

namespace safety_control_cloud {
namespace {

/// A cloud that is taken, sent and looked at all at once.
Decision decide(SafetyControl& control, const Reading& cloud, double now = 1.0) {
  return control.decide(cloud, Origin{now}, Instant{now, now});
}

Decision decide_at(double distance, SafetyControl& control, double now = 1.0) {
  const std::vector<Xyz> points = {{0.0f, 0.0f, static_cast<float>(distance)}};
  return decide(control, view_of(points), now);
}

Decision decide_alone(const std::vector<Xyz>& points) {
  SafetyControl control{Settings{}};
  return decide(control, view_of(points));
}

Decision quiet(SafetyControl& control, double now) { return control.without_cloud(Instant{now, now}); }

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
  const Decision decision = decide_alone(beside);
  EXPECT_EQ(decision.zone, Zone::Safe);
  EXPECT_EQ(decision.cause, Cause::Seen);
  EXPECT_FALSE(decision.nearest);
}

TEST(SafetyControl, RobotStandsBeforeTheFirstCloud) {
  SafetyControl control{Settings{}};
  const Decision decision = quiet(control, 100.0);
  EXPECT_EQ(decision.cause, Cause::NoCloud);
  EXPECT_EQ(decision.speed, 0.0);
}

TEST(SafetyControl, LastDecisionHoldsUntilTheSourceTimesOut) {
  SafetyControl control{Settings{}};
  decide_at(2.0, control, 10.0);
  EXPECT_EQ(quiet(control, 10.5).speed, 0.2);
  const Decision decision = quiet(control, 10.6);
  EXPECT_EQ(decision.cause, Cause::Silent);
  EXPECT_EQ(decision.zone, Zone::Danger);
  EXPECT_EQ(decision.speed, 0.0);
  EXPECT_FALSE(decision.nearest);
}

TEST(SafetyControl, RobotGoesOnByItselfWhenTheCameraIsBack) {
  SafetyControl control{Settings{}};
  decide_at(2.0, control, 10.0);
  quiet(control, 20.0);
  EXPECT_EQ(decide_at(2.0, control, 20.1).speed, 0.2);
}

TEST(SafetyControl, RobotStandsWhenNothingReturns) {
  for (const auto& points : {std::vector<Xyz>{}, {{nan, nan, nan}}, {{0, 0, 0}}, {{0, 0, inf}, {nan, 0, 1}}}) {
    SafetyControl control{Settings{}};
    decide_at(2.0, control);
    const Decision decision = decide(control, view_of(points), 1.1);
    EXPECT_EQ(decision.cause, Cause::Blind);
    EXPECT_EQ(decision.zone, Zone::Danger);
    EXPECT_EQ(decision.speed, 0.0);
  }
}

TEST(SafetyControl, RobotStandsWhenTooLittleReturnsToTellFreeFromBlind) {
  std::vector<Xyz> points(100, Xyz{nan, nan, nan});
  std::fill_n(points.begin(), 9, Xyz{0.0f, 0.0f, 3.0f});
  EXPECT_EQ(decide_alone(points).cause, Cause::Blind);
  points[9] = points[0];
  EXPECT_EQ(decide_alone(points).cause, Cause::Seen);
}

TEST(SafetyControl, RobotStandsForEveryMalformedCloud) {
  for (const auto& malformed : malformed_clouds()) {
    SafetyControl control{Settings{}};
    decide_at(2.0, control);
    const auto [layout, size] = malformed.cloud();
    const std::vector<std::uint8_t> bytes(size);
    const Decision decision = decide(control, view_of(layout, bytes.data(), bytes.size()), 1.1);
    EXPECT_EQ(decision.cause, Cause::Unreadable) << malformed.name;
    EXPECT_EQ(decision.speed, 0.0) << malformed.name;
    EXPECT_FALSE(decision.reason.empty()) << malformed.name;
  }
}

TEST(SafetyControl, UnreadableCloudKeepsTheCameraFromCountingAsSilent) {
  SafetyControl control{Settings{}};
  decide(control, Unreadable{"no field x"}, 5.0);
  EXPECT_EQ(quiet(control, 5.4).cause, Cause::Unreadable);
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

TEST(SafetyControl, UnfitSettingsAreNotTakenAndTheOldOnesStay) {
  SafetyControl control{Settings{}};
  Settings unfit;
  unfit.limits.danger = 3.0;
  unfit.speeds.safe = 0.5;
  EXPECT_THROW(control.adopt(unfit), std::invalid_argument);
  EXPECT_EQ(decide_at(2.0, control).speed, 0.2);
  unfit.limits.danger = 0.5;
  control.adopt(unfit);
  EXPECT_EQ(decide_at(2.0, control).speed, 0.5);
}

TEST(SafetyControl, OtherSettingsCountAtOnceWhereTheyAreSlower) {
  for (const double distance : {2.0, 0.8}) {
    SafetyControl control{Settings{}};
    const double before = decide_at(distance, control, 1.0).speed;
    Settings settings;
    settings.speeds.safe = settings.speeds.warning = 0.05;
    control.adopt(settings);
    EXPECT_EQ(control.without_cloud({1.05, 1.05}).speed, 0.05);
    control.adopt(Settings{});
    EXPECT_EQ(control.without_cloud({1.05, 1.05}).speed, 0.05) << "faster with the next cloud";
    settings.limits = {2.5, 2.2};
    control.adopt(settings);
    EXPECT_EQ(control.without_cloud({1.05, 1.05}).speed, 0.0);
    EXPECT_EQ(control.without_cloud({1.05, 1.05}).zone, Zone::Danger);
    control.adopt(Settings{});
    EXPECT_EQ(decide_at(distance, control, 1.1).speed, before);
  }
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
