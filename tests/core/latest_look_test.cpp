// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/latest_look.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "guard/xtion.hpp"
#include "scene.hpp"

namespace safety_control_cloud {
namespace {

constexpr Heights heights{0.05, 0.55};
const Outlook from_xtion{{}, std::get<Placement>(xtion())};

LatestLook of_camera() {
  static const Scene wall({post(2.0f, 0.0f, 9.0f)});
  static const View view = wall.view();
  return {Reading{wall.view()}, view, from_xtion, heights, {}};
}

/// It turns once a second, and measures from 0.2 m on.
LatestLook of_laser(double lasts = 1.0) {
  ScanView scan{};
  scan.first = -3.1, scan.last = 3.1, scan.range_min = 0.2, scan.range_max = 9.0, scan.lasts = lasts;
  return {Reading{scan}, View{scan.points}, from_xtion, heights, {}};
}

TEST(LatestLook, IsAsOldAsTheClockThatSaysMore) {
  LatestLook look = of_camera();
  look.arrival = {10.0, 1000.0}, look.time_to_arrive = 0.05;
  EXPECT_NEAR(look.age_at({10.1, 1000.1}), 0.15, 1e-9);
  EXPECT_NEAR(look.age_at({10.1, 1000.4}), 0.45, 1e-9);
  EXPECT_NEAR(look.age_at({10.3, 1000.0}), 0.35, 1e-9);
  EXPECT_NEAR(look.stamp(), 999.95, 1e-9);
}

TEST(LatestLook, MayHaveLastedAsLongAsItWasOnItsWayIfItsStampMayBeOff) {
  for (const double lasts : {0.0, 0.1, 1.0}) {
    LatestLook look = of_laser(lasts);
    look.time_to_arrive = 0.1;
    EXPECT_EQ(look.may_last(), lasts);
    look.time_to_arrive = 0.5;
    EXPECT_EQ(look.may_last(), std::max(0.5, lasts));
  }
}

TEST(LatestLook, HasOneWayByOdometryAndTwoIfItsStampMayBeOffOrItLasts) {
  Odometry odometry;
  for (int i = 0; i <= 40; ++i) odometry.note(0.05 * i, {{0.05 * i, 0.0}, 0.0}, {1.0, 0.0, 0.0});
  const Given given{Following{}};
  const auto ways = [&](LatestLook look, double time_to_arrive) {
    look.arrival = {1.5, 1.5}, look.time_to_arrive = time_to_arrive;
    return look.ways_since({2.0, 2.0}, odometry, given);
  };
  ASSERT_EQ(ways(of_camera(), 0.1).size(), 1U);
  EXPECT_NEAR(ways(of_camera(), 0.1)[0].place.x, 0.6, 1e-6);
  ASSERT_EQ(ways(of_camera(), 0.5).size(), 2U);
  EXPECT_NEAR(ways(of_camera(), 0.5)[1].place.x, 0.5, 1e-6);
  EXPECT_EQ(ways(of_laser(), 0.1).size(), 2U);
}

TEST(LatestLook, OfACameraMissesWhatStandsAllBelowItsPictureOrAllAbove) {
  const LatestLook look = of_camera();
  EXPECT_FALSE(look.misses({1.0, 0.0}, heights, 0.0));
  EXPECT_TRUE(look.misses({0.3, 0.0}, {0.0, 0.05}, 0.0)) << "below";
  EXPECT_TRUE(look.misses({0.3, 0.0}, {0.6, 0.9}, 0.0)) << "above";
  EXPECT_FALSE(look.misses({0.3, 0.0}, {0.0, 0.9}, 0.0)) << "through all of it";
  EXPECT_FALSE(look.misses({0.3, 0.9}, {0.0, 0.05}, 0.0)) << "it does not look there";
}

TEST(LatestLook, OfALaserMissesWhatIsNearerThanItMeasures) {
  const LatestLook look = of_laser();
  EXPECT_TRUE(look.misses({0.0, 0.0}, heights, 0.0));
  EXPECT_FALSE(look.misses({0.3, 0.0}, heights, 0.0));
  EXPECT_TRUE(look.misses({0.3, 0.0}, heights, 0.2)) << "it may be nearer";
}

}  // namespace
}  // namespace safety_control_cloud
