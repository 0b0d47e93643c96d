// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/path/escape.hpp"

#include <gtest/gtest.h>

#include "footprints.hpp"

namespace safety_control_cloud {
namespace {

constexpr double noise = 0.01;

bool comes_nearer(const Twist2& twist, const Point2& point, double duration = 1.0) {
  return comes_nearer(long_robot(), twist, point, duration, noise);
}

TEST(Escape, WhatStandsInTheFrontIsLeftBackward) {
  EXPECT_FALSE(comes_nearer({-0.1, 0.0, 0.0}, {-0.05, 0.0}));
  EXPECT_TRUE(comes_nearer({0.1, 0.0, 0.0}, {-0.05, 0.0}));
}

TEST(Escape, WhatStandsInTheRightFlankIsLeftByTurningRight) {
  EXPECT_FALSE(comes_nearer({0.0, 0.0, -0.1}, {-1.0, -0.09}));
  EXPECT_TRUE(comes_nearer({0.0, 0.0, 0.1}, {-1.0, -0.09}));
}

TEST(Escape, WhoSlidesAlongComesNoNearer) { EXPECT_FALSE(comes_nearer({0.1, 0.0, 0.0}, {-1.0, 0.12})); }

TEST(Escape, AShortMotionTowardAThingIsNoWayOut) {
  EXPECT_TRUE(comes_nearer({0.1, 0.0, 0.0}, {0.02, 0.0}, 0.01));
  EXPECT_TRUE(comes_nearer({0.1, 0.01, 0.0}, {-1.0, 0.12}, 0.01));
}

TEST(Escape, WhatIsPassedMustNotComeNearerOnTheWay) {
  // The corner swings past the point: nearer by 2 cm in the middle, and away again at the end.
  const Outline square = polygon({{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}});
  const Point2 beside = moved({0.33, 0.33}, {0.0, 0.0, 1.0}, -0.15);
  EXPECT_LT(square.signed_distance(beside) - square.signed_distance({0.33, 0.33}), 0.1);
  EXPECT_TRUE(comes_nearer(square, {0.0, 0.0, 1.0}, beside, 0.3, noise));
  EXPECT_FALSE(comes_nearer(square, {0.0, 0.0, 1.0}, beside, 0.3, 0.2));
}

TEST(Escape, EvenATouchedThingCanBeLeft) {
  for (const double distance : {1e-3, 1e-6, 1e-9, 0.0}) {
    const double allowance = allowance_for(distance, noise);
    EXPECT_EQ(comes_nearer(long_robot(), {-0.1, 0.0, 0.0}, {distance, 0.0}, 1.0, allowance), false) << distance;
  }
}

TEST(Escape, OutsideTheFootprintHalfOfTheWayIsAlwaysLeft) {
  EXPECT_EQ(allowance_for(1.0, noise), noise);
  EXPECT_EQ(allowance_for(0.004, noise), 0.002);
  EXPECT_EQ(allowance_for(-0.004, noise), noise);
}

TEST(Escape, DoubtIsNearer) {
  EXPECT_TRUE(comes_nearer({-0.1, 0.0, 0.0}, {NAN, 0.0}));
  EXPECT_TRUE(comes_nearer(long_robot(), {-0.1, 0.0, 0.0}, {0.05, 0.0}, 1.0, 0.0));
  EXPECT_TRUE(comes_nearer(long_robot(), {-0.1, 0.0, 0.0}, {0.05, 0.0}, 1.0, NAN));
}

}  // namespace
}  // namespace safety_control_cloud
