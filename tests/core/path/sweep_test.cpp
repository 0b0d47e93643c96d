// SPDX-License-Identifier: BSD-3-Clause
// What a person can compute by hand; tests/python/path compares with a naive drive.
#include "../../../safety_control_cloud/core/path/sweep.hpp"

#include <gtest/gtest.h>

#include <random>

#include "footprints.hpp"

namespace safety_control_cloud {
namespace {

double time_to(const Outline& outline, const Twist2& twist, const Point2& point) {
  return Sweep(outline, twist).time_to_contact(point);
}

TEST(Sweep, StraightAheadIsDistanceOverSpeed) {
  EXPECT_DOUBLE_EQ(time_to(long_robot(), {2.0, 0.0, 0.0}, {0.5, 0.0}), 0.25);
  EXPECT_DOUBLE_EQ(time_to(long_robot(0.1), {2.0, 0.0, 0.0}, {0.5, 0.0}), 0.2);
  EXPECT_DOUBLE_EQ(time_to(long_robot(), {-0.5, 0.0, 0.0}, {-3.0, 0.05}), 2.0);
  EXPECT_DOUBLE_EQ(time_to(long_robot(), {0.0, 0.5, 0.0}, {-1.0, 1.1}), 2.0);
  EXPECT_EQ(time_to(long_robot(), {2.0, 0.0, 0.0}, {0.5, 0.11}), infinity);
}

TEST(Sweep, ACornerIsRound) {
  const double margin = 0.5;  // at 0.3 m beside the corner the arc lies 0.4 m ahead of it
  EXPECT_NEAR(time_to(long_robot(margin), {1.0, 0.0, 0.0}, {2.0, 0.4}), 1.6, 1e-12);
  EXPECT_EQ(time_to(long_robot(margin), {1.0, 0.0, 0.0}, {2.0, 0.6001}), infinity);
}

TEST(Sweep, ACircleOnAnArcIsTouchedByItsSide) {
  // Around (0, 1), which lies 1 m from the robot's middle: the point stands 1 m from it as well, 90 degrees on. The
  // circle touches it when their angle is that of a chord of 0.2 m.
  const double angle = pi / 2.0 - 2.0 * std::asin(0.1);
  EXPECT_NEAR(time_to(circle(0.2), {0.5, 0.0, 0.5}, {1.0, 1.0}), angle / 0.5, 1e-12);
  EXPECT_NEAR(time_to(circle(0.2), {0.5, 0.0, -0.5}, {1.0, -1.0}), angle / 0.5, 1e-12);
  EXPECT_NEAR(time_to(circle(0.2), {-0.5, 0.0, 0.5}, {-1.0, -1.0}), angle / 0.5, 1e-12);
}

TEST(Sweep, OnlyNearlyAFullTurnLeadsToWhatIsJustBehind) {
  const double angle = pi / 2.0 - 2.0 * std::asin(0.1);
  EXPECT_NEAR(time_to(circle(0.2), {0.5, 0.0, 0.5}, {-1.0, 1.0}), (angle + pi) / 0.5, 1e-12);
  const double behind = 2.0 * std::asin(0.15), touched = 2.0 * std::asin(0.1);
  EXPECT_NEAR(time_to(circle(0.2), {0.5, 0.0, 0.5}, {-std::sin(behind), 1.0 - std::cos(behind)}),
              (2.0 * pi - behind - touched) / 0.5, 1e-9);
}

TEST(Sweep, TurningInPlaceSwingsTheTail) {
  const double start = std::atan2(1.1, 1.0), end = std::asin(0.1 / std::hypot(1.0, 1.1));
  EXPECT_NEAR(time_to(long_robot(), {0.0, 0.0, 1.0}, {-1.0, -1.1}), start - end, 1e-12);
}

TEST(Sweep, ACircleThatTurnsInPlaceTouchesNothing) {
  for (const double radius : {0.2, 0.2 + 1e-12, 0.2 - 1e-12, 0.21, 3.0}) {
    for (int i = 0; i < 100; ++i)
      EXPECT_EQ(time_to(circle(0.15, 0.05), {0.0, 0.0, 1.3}, {radius * std::cos(i), radius * std::sin(i)}), infinity);
  }
}

TEST(Sweep, APointAtTheCentreOfRotationRests) {
  EXPECT_EQ(time_to(circle(0.2), {0.5, 0.0, 0.5}, {0.0, 1.0}), infinity);
  EXPECT_EQ(time_to(polygon({{1, 1}, {2, 1}, {2, 2}, {1, 2}}), {0.0, 0.0, 1.0}, {0.0, 0.0}), infinity);
}

TEST(Sweep, AFootprintBesideTheOriginIsSweptAroundIt) {
  const Outline beside = polygon({{1, -0.5}, {2, -0.5}, {2, 0.5}, {1, 0.5}});
  EXPECT_NEAR(time_to(beside, {0.0, 0.0, 1.0}, {0.0, 1.5}), pi / 2.0 - std::asin(0.5 / 1.5), 1e-12);
  EXPECT_EQ(time_to(beside, {0.0, 0.0, 1.0}, {0.0, 0.9}), infinity);
  EXPECT_EQ(time_to(beside, {0.0, 0.0, 1.0}, {0.0, 2.1}), infinity);
}

TEST(Sweep, APointInAPocketIsTouchedByTheWallsOfThePocket) {
  EXPECT_DOUBLE_EQ(time_to(fork(), {1.0, 0.0, 0.0}, {0.2, 0.0}), 0.5);
  EXPECT_EQ(time_to(fork(), {-1.0, 0.0, 0.0}, {0.2, 0.0}), infinity);
  EXPECT_DOUBLE_EQ(time_to(fork(), {0.0, 1.0, 0.0}, {0.2, 0.0}), 0.3);
  EXPECT_NEAR(time_to(fork(0.1), {0.0, -1.0, 0.0}, {0.2, 0.0}), 0.2, 1e-12);
  EXPECT_NEAR(time_to(fork(0.1), {1.0, 0.0, 0.0}, {2.0, 0.0}), 2.2, 1e-12);
}

TEST(Sweep, WhatIsInsideIsTouchedNow) {
  EXPECT_EQ(time_to(long_robot(), {-1.0, 0.0, 0.0}, {-0.05, 0.0}), 0.0);
  EXPECT_EQ(time_to(long_robot(0.1), {-1.0, 0.0, 0.0}, {0.05, 0.0}), 0.0);
  EXPECT_EQ(time_to(circle(0.2, 0.1), {}, {0.25, 0.0}), 0.0);
}

TEST(Sweep, OnTheBoundaryOnlyWhoMovesInwardTouches) {
  for (const double rounding : {0.0, 5e-10, -5e-10}) {
    const Point2 ahead{0.3 + rounding, 0.0};
    EXPECT_EQ(time_to(circle(0.2, 0.1), {-1.0, 0.0, 0.0}, ahead), infinity);
    EXPECT_EQ(time_to(circle(0.2, 0.1), {0.0, 1.0, 0.0}, ahead), infinity);
    EXPECT_NEAR(time_to(circle(0.2, 0.1), {1.0, 0.0, 0.0}, ahead), 0.0, 1e-9);
    EXPECT_EQ(time_to(fork(0.1), {-1.0, 0.0, 0.0}, {-0.2 + rounding, 0.0}), infinity);
    EXPECT_NEAR(time_to(fork(0.1), {1.0, 0.0, 0.0}, {-0.2 + rounding, 0.0}), 0.0, 1e-9);
  }
}

TEST(Sweep, ASideThatTurnsOverItsNearestPointTouchesIt) {
  EXPECT_NEAR(time_to(fork(), {0.0, 0.0, 1.0}, {-0.5, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(time_to(fork(), {0.0, 0.0, -1.0}, {-0.5, 0.0}), 0.0, 1e-12);
}

TEST(Sweep, NothingIsAskedBeyondTheHorizon) {
  EXPECT_EQ(Sweep(long_robot(), {2.0, 0.0, 0.0}, 0.0, 0.24).time_to_contact({0.5, 0.0}), infinity);
  EXPECT_EQ(Sweep(long_robot(), {2.0, 0.0, 0.0}, 0.0, 0.26).time_to_contact({0.5, 0.0}), 0.25);
}

/// Of a random robot, motion and place, many times.
TEST(Sweep, WhoAsksForTheFirstNeedNotKnowOfLaterContacts) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> upto(-1.0, 1.0);
  int touched = 0;
  for (int i = 0; i < 20000; ++i) {
    const double turning = i % 5 == 0 ? 0.0 : 2.0 * upto(random), speed = i % 7 == 0 ? 0.0 : 1.0;
    const Twist2 twist{speed * upto(random), 0.3 * speed * upto(random), turning};
    const Sweep sweep(i % 2 == 0 ? long_robot(0.1) : circle(0.2), twist);
    const Point2 point{1.5 * upto(random), 1.5 * upto(random)};
    const double time = sweep.time_to_contact(point);
    touched += time < infinity;
    for (const double share : {0.5, 0.999999, 1.0, 1.000001, 2.0}) {
      const double told = sweep.time_to_contact(point, share * time);
      if (told == time) continue;
      EXPECT_EQ(told, infinity);
      EXPECT_LE(share, 1.0) << "a contact before that is known";
    }
  }
  EXPECT_GT(touched, 3000);
}

TEST(Sweep, DoubtIsContact) {
  EXPECT_EQ(time_to(circle(0.2), {1.0, 0.0, 0.0}, {NAN, 0.0}), 0.0);
  EXPECT_EQ(time_to(circle(0.2), {NAN, 0.0, 0.0}, {9.0, 0.0}), 0.0);
  EXPECT_EQ(time_to(circle(0.2), {0.0, 0.0, INFINITY}, {9.0, 0.0}), 0.0);
  EXPECT_EQ(Sweep(circle(0.2), {1.0, 0.0, 0.0}, NAN).time_to_contact({9.0, 0.0}), 0.0);
  EXPECT_EQ(Sweep(circle(0.2), {1.0, 0.0, 0.0}, 0.0, NAN).time_to_contact({9.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace safety_control_cloud
