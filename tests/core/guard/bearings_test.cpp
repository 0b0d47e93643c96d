// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/bearings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

/// [rad] in the sensor's frame.
double rad(double degrees) { return degrees * pi / 180.0; }

/// A whole turn from the back on, a beam a degree.
struct Laser {
  std::vector<float> ranges = std::vector<float>(360, 5.0f);
  bool descends = false;
  Bearings bearings;

  bool is_in_a_gap(double bearing) const {
    const auto holds = [=](const Bearings::Gap& gap) {
      return std::abs(wrapped(bearing - gap.middle)) <= gap.half_angle;
    };
    return std::any_of(bearings.gaps().begin(), bearings.gaps().end(), holds);
  }

  /// From one bearing to another [degrees].
  void shows(int from, int to, float range) {
    for (int i = from; i < to; ++i) ranges[static_cast<std::size_t>(descends ? 180 - i : i + 180) % 360] = range;
  }
  void looks(double at = 0.0) {
    Scan scan;
    scan.angle_min = descends ? pi : -pi, scan.angle_increment = (descends ? -1.0 : 1.0) * rad(1.0);
    scan.angle_max = scan.angle_min + 359.0 * scan.angle_increment;
    scan.range_min = 0.1, scan.range_max = 10.0, scan.ranges = ranges.data(), scan.size = ranges.size();
    ScanPoints points;
    bearings.note(points.of(scan), Outlook({}, std::get<Placement>(laser_at(0.2))), at);
  }
};

TEST(Bearings, WhatHasNeverMeasuredIsBlindWhateverStandsInItsPlace) {
  for (const float blank : {nan, 0.0f, 0.05f, 10.5f}) {
    for (const bool descends : {false, true}) {
      Laser laser;
      laser.descends = descends;
      laser.shows(20, 50, blank);
      laser.looks();
      for (const double inside : {22.0, 35.0, 48.0}) EXPECT_TRUE(laser.is_in_a_gap(rad(inside))) << blank;
      for (const double outside : {-35.0, 18.0, 52.0, 180.0, -180.0, 325.0, 720.0})
        EXPECT_FALSE(laser.is_in_a_gap(rad(outside))) << outside << ", " << blank;
      ASSERT_EQ(laser.bearings.gaps().size(), 1u);
      EXPECT_NEAR(laser.bearings.gaps()[0].middle, rad(34.5), rad(1.0));
      EXPECT_NEAR(laser.bearings.gaps()[0].half_angle, rad(15.0), rad(1.0));
    }
  }
}

TEST(Bearings, AnInfinityHasSeenThatNothingIsThereAndTooCloseIsAMeasurementToo) {
  for (const float measured : {inf, -inf, 0.1f, 10.0f}) {
    Laser laser;
    laser.shows(20, 50, measured);
    laser.looks();
    EXPECT_TRUE(laser.bearings.gaps().empty()) << measured;
  }
}

TEST(Bearings, WhatMeasuredIsBlindASecondAfterItLastDid) {
  Laser laser;
  laser.shows(20, 50, nan);
  laser.looks(0.0);
  EXPECT_TRUE(laser.is_in_a_gap(rad(35.0))) << "never";
  laser.shows(20, 50, 3.0f);
  laser.looks(0.1);
  laser.shows(20, 50, nan);
  for (const double now : {0.2, 0.6, 1.05}) {
    laser.looks(now);
    EXPECT_TRUE(laser.bearings.gaps().empty()) << now;
  }
  laser.looks(1.15);
  EXPECT_TRUE(laser.is_in_a_gap(rad(35.0)));
  EXPECT_FALSE(laser.is_in_a_gap(rad(55.0)));
  laser.shows(30, 31, 3.0f);
  laser.looks(1.2);
  EXPECT_FALSE(laser.is_in_a_gap(rad(25.0))) << "what is left before it is narrow";
  EXPECT_TRUE(laser.is_in_a_gap(rad(40.0)));
}

TEST(Bearings, WhatHasNotMeasuredForASecondMeasuresNothingHoweverNarrowItIs) {
  EXPECT_TRUE(Bearings().measures_at(0.0)) << "nobody knows yet";
  Laser laser;
  laser.looks(0.0);
  for (const auto& [from, to] : {std::pair(30, 32), std::pair(-10, 2)}) laser.shows(from, to, nan);
  for (const double now : {0.1, 0.9}) {
    laser.looks(now);
    EXPECT_TRUE(laser.bearings.measures_at(rad(30.5))) << now;
  }
  laser.looks(1.1);
  EXPECT_TRUE(laser.bearings.gaps().empty());
  for (const double blank : {30.5, -4.0, -9.0, 1.0}) EXPECT_FALSE(laser.bearings.measures_at(rad(blank))) << blank;
  for (const double seen : {28.5, 33.0, -12.0, 3.0, 180.0}) EXPECT_TRUE(laser.bearings.measures_at(rad(seen))) << seen;
}

TEST(Bearings, ZeroIsAMeasurementWhereItSaysWhatInfinitySays) {
  for (const auto zero : {Bearings::Zero::Nothing, Bearings::Zero::WhatInfSays}) {
    Laser laser;
    laser.bearings = Bearings({}, zero);
    laser.shows(20, 50, 0.0f);
    laser.shows(90, 120, nan);
    laser.shows(-50, -20, inf);
    laser.looks();
    EXPECT_EQ(laser.is_in_a_gap(rad(35.0)), zero == Bearings::Zero::Nothing);
    EXPECT_TRUE(laser.is_in_a_gap(rad(105.0)));
    EXPECT_FALSE(laser.is_in_a_gap(rad(-35.0)));
  }
}

TEST(Bearings, ANarrowGapIsNone) {
  Laser laser;
  laser.shows(20, 30, nan);
  laser.shows(60, 70, nan);
  laser.looks();
  EXPECT_TRUE(laser.bearings.gaps().empty());
}

TEST(Bearings, AGapGoesOnOverTheSeam) {
  Laser laser;
  laser.shows(100, 180, nan);
  laser.shows(-180, -100, nan);
  laser.looks();
  for (const double inside : {102.0, 180.0, -180.0, -102.0, 250.0})
    EXPECT_TRUE(laser.is_in_a_gap(rad(inside))) << inside;
  ASSERT_EQ(laser.bearings.gaps().size(), 1u);
  EXPECT_NEAR(laser.bearings.gaps()[0].middle, pi, rad(1.0));
}

TEST(Bearings, ALaserDoesNotLookThroughTheRobotItself) {
  Laser laser;
  laser.bearings = Bearings({{-0.16, -0.1, -0.05, 0.05, 0.0, 1.0}});
  laser.shows(156, 180, 0.12f);
  laser.shows(-180, -156, 0.12f);
  laser.looks();
  EXPECT_TRUE(laser.is_in_a_gap(pi));
  laser.bearings = Bearings();
  laser.looks();
  EXPECT_FALSE(laser.is_in_a_gap(pi)) << "something else";
}

TEST(Bearings, BeamsThatLieFarApartLeaveNoGap) {
  Bearings bearings;
  const std::vector<float> ranges(12, 2.0f);
  Scan scan;
  scan.angle_min = -pi, scan.angle_increment = rad(30.0), scan.angle_max = -pi + 11.0 * scan.angle_increment;
  scan.range_min = 0.1, scan.range_max = 10.0, scan.ranges = ranges.data(), scan.size = ranges.size();
  ScanPoints points;
  bearings.note(points.of(scan), Outlook({}, std::get<Placement>(laser_at(0.2))), 0.0);
  EXPECT_TRUE(bearings.gaps().empty());
}

TEST(Bearings, WhoMeasuresNothingAtAllLooksNowhere) {
  Laser laser;
  laser.looks(0.0);
  laser.shows(-180, 180, nan);
  laser.looks(0.5);
  EXPECT_FALSE(laser.is_in_a_gap(0.0));
  laser.looks(2.0);
  for (const double any : {0.0, 1.5, pi, -pi}) EXPECT_TRUE(laser.is_in_a_gap(any)) << any;
}

}  // namespace
}  // namespace safety_control_cloud
