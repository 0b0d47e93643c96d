// SPDX-License-Identifier: BSD-3-Clause
// That it bounds a base driven in small steps, tests/python/path/test_fan.py shows.
#include "../../../safety_control_cloud/core/speed/fan.hpp"

#include <gtest/gtest.h>

#include "../path/footprints.hpp"

namespace safety_control_cloud {
namespace {

const Law law;

std::optional<Fan> fan_of(const Twist2& under_way, const Twist2& wanted, const Factors& factors = {0.0, 1.0}) {
  return fan(circle(0.2, 0.05), law, response_to(law, {}, wanted), under_way, wanted, factors);
}

TEST(Fan, OfOneStraightWayIsThatAlone) {
  const auto fan = fan_of({0.15, 0.0, 0.0}, {0.3, 0.0, 0.0});
  ASSERT_TRUE(fan);
  EXPECT_DOUBLE_EQ(fan->share, 0.5);
  EXPECT_EQ(fan->widening, 0.0);
  for (const Twist2& twist : fan->twists) EXPECT_EQ(twist.w, 0.0);
}

TEST(Fan, HoldsTheOldArcTheNewOneAndTheTangentWithWhatLiesBetween) {
  const auto fan = fan_of({0.25, 0.0, -0.1}, {0.5, 0.0, 0.6});
  ASSERT_TRUE(fan);
  EXPECT_DOUBLE_EQ(fan->twists.front().w, -0.2) << "the old curvature, at the new speed";
  EXPECT_DOUBLE_EQ(fan->twists.back().w, 0.6);
  for (std::size_t i = 1; i < Fan::size; ++i) EXPECT_NEAR(fan->twists[i].w - fan->twists[i - 1].w, 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(fan_of({0.5, 0.0, 0.6}, {0.5, 0.0, 0.6})->twists.front().w, 0.0) << "who turns brakes that first";
}

TEST(Fan, LeavesLessToBothSidesThanOnePathDoes) {
  const Outline outline = circle(0.2, 0.05);
  const Twist2 ahead{0.5, 0.0, 0.0}, around{0.5, 0.0, -0.5};
  const Response response = response_to(law, {}, around);
  const double one_path = straying(outline, law, response, ahead, around, {1.0, 1.0}).widening;
  EXPECT_LT(fan(outline, law, response, ahead, around, {1.0, 1.0})->widening, 0.5 * one_path);
}

TEST(Fan, GrowsWithWhatTheSpeedIsBehindTheTurning) {
  const Twist2 wanted{0.5, 0.0, 0.5};
  EXPECT_GT(fan_of({0.0, 0.0, 0.0}, wanted)->widening, fan_of({0.4, 0.0, 0.4}, wanted)->widening)
      << "it has to gain speed";
  EXPECT_GT(fan_of({0.5, 0.0, 1.5}, wanted)->widening, fan_of({0.5, 0.0, 0.5}, wanted)->widening)
      << "it has to lose turning";
}

TEST(Fan, IsMirrored) {
  EXPECT_DOUBLE_EQ(fan_of({0.3, 0.0, 0.2}, {0.5, 0.0, -0.7})->widening,
                   fan_of({0.3, 0.0, -0.2}, {0.5, 0.0, 0.7})->widening);
  EXPECT_DOUBLE_EQ(fan_of({0.3, 0.0, 0.2}, {0.5, 0.0, -0.7})->widening,
                   fan_of({-0.3, 0.0, 0.2}, {-0.5, 0.0, -0.7})->widening);
}

TEST(Fan, ASlightMotionAcrossIsAddedToIt) {
  const double along = fan_of({0.4, 0.0, 0.2}, {0.5, 0.0, 0.3})->widening;
  const double across = fan_of({0.4, 0.003, 0.2}, {0.5, 0.0, 0.3})->widening;
  EXPECT_GT(across, along + 0.003 * 0.15);
  EXPECT_LT(across, along + 0.02);
}

TEST(Fan, IsNoneForWhoDoesNotDriveInTheSameDirection) {
  EXPECT_FALSE(fan_of({-0.1, 0.0, 0.0}, {0.3, 0.0, 0.0}));
  EXPECT_FALSE(fan_of({0.1, 0.1, 0.0}, {0.3, 0.0, 0.0}));
  EXPECT_FALSE(fan_of({0.0, 0.0, 1.0}, {0.3, 0.0, 0.0}));
  EXPECT_FALSE(fan_of({0.1, 0.0, 0.0}, {0.0, 0.0, 1.0}));
}

}  // namespace
}  // namespace safety_control_cloud
