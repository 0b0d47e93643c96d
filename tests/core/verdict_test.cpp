// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/verdict.hpp"

#include <gtest/gtest.h>

#include "scene.hpp"

namespace safety_control_cloud {
namespace {

Decision verdict_of(const std::vector<Xyz>& points, const ZoneLimits& limits = {}) {
  Sensor sensor{Settings{}};
  sensor.see(view_of(points), Origin{1.0}, Instant{1.0, 1.0});
  return verdict_on(sensor, limits);
}

TEST(Verdict, IsTheZoneOfTheNearestObstacle) {
  EXPECT_EQ(verdict_of({{0, 0, 2}}).zone, Zone::Safe);
  EXPECT_EQ(verdict_of({{0, 0, 2}, {0, 0, 0.8f}}).zone, Zone::Warning);
  EXPECT_EQ(verdict_of({{0, 0, 0.4f}}).zone, Zone::Danger);
  EXPECT_EQ(verdict_of({{0, 0, 0.8f}}, {0.7, 0.6}).zone, Zone::Safe) << "by the limits that are given";
  EXPECT_EQ(verdict_of({{0, 0, 0.8f}}).reason, "nearest obstacle at 0.800 m");
  EXPECT_EQ(verdict_of({{3, 0, 0.4f}}).reason, "corridor is free");
  EXPECT_EQ(verdict_of({{0, 0, 2}}).speed, 0.0) << "which is not its own to say";
}

TEST(Verdict, EveryDoubtIsDanger) {
  for (int number = 1; number <= 17; ++number) {
    const auto cause = static_cast<Cause>(number);
    Sight counted;
    counted.returns = 7;
    const Decision decision = standing_for(Doubt{cause, "why"}, counted);
    EXPECT_EQ(decision.zone, Zone::Danger);
    EXPECT_EQ(decision.cause, cause);
    EXPECT_EQ(decision.reason, "why");
    EXPECT_EQ(decision.sight.returns, std::size_t{7}) << "what was counted is told all the same";
    EXPECT_FALSE(decision.nearest);
  }
}

TEST(Verdict, OfASensorThatHasSeenNothingYetIsDanger) {
  const Decision decision = verdict_on(Sensor{Settings{}}, {});
  EXPECT_EQ(decision.zone, Zone::Danger);
  EXPECT_EQ(decision.cause, Cause::NoCloud);
}

TEST(Verdict, WhatWasLostCountsWhereItIsWorseThanWhatIsSeen) {
  Sensor sensor{Settings{}};
  double now = 1.0;
  const auto see = [&](const Scene& scene) {
    now += 0.05;
    sensor.see(scene.view(), Origin{now}, Instant{now, now});
    return verdict_on(sensor, {});
  };
  EXPECT_EQ(see(Scene{{{0.45f, -0.2f, 0.2f, -0.2f, 0.2f}, {3.0f, -9, 9, -9, 9}}}).cause, Cause::Seen);
  const Decision lost = see(Scene{{{0.39f, -0.2f, 0.2f, -0.2f, 0.2f}, {3.0f, -9, 9, -9, 9}}});
  EXPECT_EQ(lost.cause, Cause::NearLoss);
  EXPECT_EQ(lost.zone, Zone::Danger);
  EXPECT_FALSE(lost.hint.empty());
}

}  // namespace
}  // namespace safety_control_cloud
