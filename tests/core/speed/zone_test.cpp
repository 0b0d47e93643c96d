// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/speed/zone.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace safety_control_cloud {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Zone, FartherThanTheWarningDistanceIsSafe) {
  EXPECT_EQ(zone_at(std::nextafter(1.0, 2.0), {}), Zone::Safe);
  EXPECT_EQ(zone_at(kInfinity, {}), Zone::Safe);
}

TEST(Zone, AtTheWarningDistanceTheRobotSlows) { EXPECT_EQ(zone_at(1.0, {}), Zone::Warning); }

TEST(Zone, JustBeyondTheDangerDistanceTheRobotStillMoves) {
  EXPECT_EQ(zone_at(std::nextafter(0.5, 1.0), {}), Zone::Warning);
}

TEST(Zone, AtTheDangerDistanceTheRobotStands) { EXPECT_EQ(zone_at(0.5, {}), Zone::Danger); }

TEST(Zone, TouchingIsDanger) {
  EXPECT_EQ(zone_at(0.0, {}), Zone::Danger);
  EXPECT_EQ(zone_at(-kInfinity, {}), Zone::Danger);
}

TEST(Zone, UnknownDistanceIsDanger) { EXPECT_EQ(zone_at(NAN, {}), Zone::Danger); }

TEST(Zone, UnknownLimitsAreDanger) { EXPECT_EQ(zone_at(5.0, {NAN, NAN}), Zone::Danger); }

TEST(ZoneLatch, StartsInDanger) {
  ZoneLatch latch({/*clouds=*/2, /*time=*/0.0});
  EXPECT_EQ(latch.update(Zone::Safe, 0.0), Zone::Danger);
}

TEST(ZoneLatch, WithoutAHoldTheRobotDrivesAtTheFirstSafeCloud) {
  ZoneLatch latch({});
  EXPECT_EQ(latch.update(Zone::Safe, 0.0), Zone::Safe);
}

TEST(ZoneLatch, WorsensAtOnce) {
  ZoneLatch latch({/*clouds=*/1, /*time=*/0.0});
  latch.update(Zone::Safe, 0.0);
  EXPECT_EQ(latch.update(Zone::Danger, 0.1), Zone::Danger);
}

TEST(ZoneLatch, OneSafeCloudBetweenDangerousOnesDoesNotMoveTheRobot) {
  ZoneLatch latch({/*clouds=*/2, /*time=*/0.0});
  for (double now = 0.0; now < 1.0; now += 0.1) {
    EXPECT_EQ(latch.update(Zone::Danger, now), Zone::Danger);
    EXPECT_EQ(latch.update(Zone::Safe, now + 0.05), Zone::Danger);
  }
}

TEST(ZoneLatch, RecoversOnlyWhenBothCloudsAndTimeHavePassed) {
  ZoneLatch latch({/*clouds=*/3, /*time=*/1.0});
  EXPECT_EQ(latch.update(Zone::Safe, 0.0), Zone::Danger);
  EXPECT_EQ(latch.update(Zone::Safe, 1.0), Zone::Danger);
  EXPECT_EQ(latch.update(Zone::Safe, 1.1), Zone::Safe);
}

TEST(ZoneLatch, RecoversToTheWorstZoneSeenDuringTheHold) {
  ZoneLatch latch({/*clouds=*/3, /*time=*/0.0});
  latch.update(Zone::Safe, 0.0);
  latch.update(Zone::Warning, 0.1);
  EXPECT_EQ(latch.update(Zone::Safe, 0.2), Zone::Warning);
}

}  // namespace
}  // namespace safety_control_cloud
