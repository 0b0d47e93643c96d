// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/path/twist.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "footprints.hpp"

namespace safety_control_cloud {
namespace {

bool same_bits(const Twist2& a, const Twist2& b) { return std::memcmp(&a, &b, sizeof(Twist2)) == 0; }

void expect_at(const Point2& point, double x, double y) {
  EXPECT_NEAR(point.x, x, 1e-12);
  EXPECT_NEAR(point.y, y, 1e-12);
}

TEST(Twist, AtFactorOneItIsEqualInEveryBit) {
  const Twist2 twist{0.1 + 0.2, -0.0, 5e-324};
  EXPECT_TRUE(same_bits(limited(twist, 1.0), twist));
  EXPECT_TRUE(same_bits(limited(twist, 1.5), twist));
}

TEST(Twist, IsLimitedAsAWhole) {
  const Twist2 half = limited({1.0, -2.0, 3.0}, 0.5);
  EXPECT_EQ(half.vx, 0.5);
  EXPECT_EQ(half.vy, -1.0);
  EXPECT_EQ(half.w, 1.5);
}

TEST(Twist, WhatIsNoFactorIsStanding) {
  for (const double factor : {0.0, -0.0, -1.0, static_cast<double>(NAN)})
    EXPECT_TRUE(same_bits(limited({1.0, -2.0, INFINITY}, factor), {}));
}

TEST(Twist, APointComesTowardARobotThatDrives) {
  expect_at(moved({3.0, 1.0}, {0.5, 0.0, 0.0}, 2.0), 2.0, 1.0);
  expect_at(moved({3.0, 1.0}, {0.0, 0.5, 0.0}, 2.0), 3.0, 0.0);
}

TEST(Twist, APointGoesAroundARobotThatTurns) {
  expect_at(moved({1.0, 0.0}, {0.0, 0.0, 1.0}, pi / 2.0), 0.0, -1.0);
  expect_at(moved({1.0, 0.0}, {0.0, 0.0, -1.0}, pi), -1.0, 0.0);
  expect_at(moved({1.0, 0.0}, {0.0, 0.0, 1.0}, 2.0 * pi), 1.0, 0.0);
}

TEST(Twist, AQuarterOfACircleLeadsAroundItsCentre) { expect_at(moved({1.0, 1.0}, {0.5, 0.0, 0.5}, pi), 0.0, 0.0); }

TEST(Twist, TheApparentSpeedOfAPointNeverChanges) {
  const Twist2 twist{0.4, -0.2, 0.9};
  const Point2 point{1.0, 2.0};
  for (const double time : {0.1, 1.0, 3.0})
    EXPECT_NEAR(length_of(apparent_velocity(twist, moved(point, twist, time))),
                length_of(apparent_velocity(twist, point)), 1e-12);
}

}  // namespace
}  // namespace safety_control_cloud
