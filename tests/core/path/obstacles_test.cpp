// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/path/obstacles.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "../../../safety_control_cloud/core/path/contact.hpp"
#include "footprints.hpp"

namespace safety_control_cloud {
namespace {

TEST(Reduced, AReturnAloneInItsCellStaysWhereItIs) {
  const Obstacles obstacles = reduced({{0.13, -0.07}, {5.0, 5.0}}, 0.1);
  ASSERT_EQ(obstacles.points.size(), 2u);
  EXPECT_EQ(obstacles.points[0].x, 0.13);
  EXPECT_EQ(obstacles.widening, 0.0);
}

TEST(Reduced, ACellStandsForAllOfItsReturns) {
  const Obstacles obstacles = reduced({{0.11, 0.11}, {0.17, 0.19}, {0.12, 0.12}}, 0.1);
  ASSERT_EQ(obstacles.points.size(), 1u);
  EXPECT_NEAR(obstacles.points[0].x, 0.14, 1e-12);
  EXPECT_NEAR(obstacles.points[0].y, 0.15, 1e-12);
  EXPECT_EQ(obstacles.counts[0], 3u);
  EXPECT_NEAR(obstacles.widening, 0.05, 1e-12);
}

TEST(Reduced, NoReturnLiesFartherFromItsPointThanTheWidening) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> anywhere(-2.0, 2.0);
  std::vector<Point2> points(500);
  for (Point2& point : points) point = {anywhere(random), anywhere(random)};
  const Obstacles obstacles = reduced(points, 0.3);
  EXPECT_LT(obstacles.points.size(), points.size());
  EXPECT_LE(obstacles.widening, 0.3 * std::sqrt(0.5));
  EXPECT_EQ(std::accumulate(obstacles.counts.begin(), obstacles.counts.end(), 0u), 500u);
  for (const Point2& point : points) {
    double nearest = infinity;
    for (const Point2& cell : obstacles.points) nearest = std::min(nearest, length_of(point - cell));
    EXPECT_LE(nearest, obstacles.widening + 1e-12);
  }
}

TEST(Reduced, WhatIsNotFiniteStays) {
  const Obstacles obstacles = reduced({{NAN, 0.0}, {1.0, INFINITY}, {1e300, -1e300}}, 1e-3);
  EXPECT_EQ(obstacles.points.size(), 3u);
}

TEST(Parted, WhatIsNearIsKeptApart) {
  const Parted parts = parted({{0.25, 0.0}, {0.0, 0.0}, {2.0, 0.0}, {NAN, 0.0}}, circle(0.2), 0.1);
  EXPECT_EQ(parts.near.size(), 3u);
  EXPECT_EQ(parts.far.size(), 1u);
}

TEST(OwnBoxes, HoldTheirLimitsAndNothingThatIsNotFinite) {
  const std::vector<OwnBox> self{{-0.1, 0.1, -0.1, 0.1, 0.3, 1.0}};
  EXPECT_TRUE(is_own(self, 0.0, 0.0, 0.5));
  EXPECT_TRUE(is_own(self, 0.1, -0.1, 1.0));
  EXPECT_FALSE(is_own(self, 0.0, 0.0, 0.2));
  EXPECT_FALSE(is_own(self, NAN, 0.0, 0.5));
  EXPECT_FALSE(is_own({}, 0.0, 0.0, 0.5));
}

TEST(Condition, IsFoundOutOnceForEachThatSomebodyAsksFor) {
  const std::vector<Point2> points{{1.0, 0.0}, {2.0, 0.0}, {3.0, 0.0}};
  std::vector<double> asked;
  const Condition beyond([&](const Point2& point) {
    asked.push_back(point.x);
    return point.x > 1.5;
  });
  for (int i = 0; i < 2; ++i) {
    EXPECT_FALSE(beyond.holds_for(points, 0));
    EXPECT_TRUE(beyond.holds_for(points, 2));
  }
  EXPECT_EQ(asked, (std::vector<double>{1.0, 3.0}));
  EXPECT_TRUE(Condition().holds_for(points, 1));
}

}  // namespace
}  // namespace safety_control_cloud
