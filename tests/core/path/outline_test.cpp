// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <stdexcept>

#include "footprints.hpp"

namespace safety_control_cloud {
namespace {

TEST(Outline, DistanceIsNegativeInside) {
  EXPECT_NEAR(long_robot().signed_distance({0.5, 0.0}), 0.5, 1e-12);
  EXPECT_NEAR(long_robot().signed_distance({3.0, 4.1}), 5.0, 1e-12);
  EXPECT_NEAR(long_robot().signed_distance({-1.0, 0.07}), -0.03, 1e-12);
  EXPECT_NEAR(circle(0.2).signed_distance({0.3, 0.4}), 0.3, 1e-12);
  EXPECT_NEAR(circle(0.2).signed_distance({0.0, 0.0}), -0.2, 1e-12);
}

TEST(Outline, APocketIsOutside) {
  EXPECT_NEAR(fork().signed_distance({0.2, 0.0}), 0.3, 1e-12);
  EXPECT_NEAR(fork().signed_distance({0.2, 0.4}), -0.1, 1e-12);
}

TEST(Outline, ARayThroughACornerCrossesOnce) {
  const Outline diamond = polygon({{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
  EXPECT_LT(diamond.signed_distance({-0.5, 0.0}), 0.0);
  EXPECT_GT(diamond.signed_distance({-1.5, 0.0}), 0.0);
  EXPECT_GT(diamond.signed_distance({-0.5, 1.0}), 0.0);
}

TEST(Outline, TheOrderOfTheCornersDoesNotMatter) {
  const Outline other = polygon({{-2.0, 0.1}, {0.0, 0.1}, {0.0, -0.1}, {-2.0, -0.1}});
  EXPECT_EQ(other.signed_distance({-1.0, 0.0}), long_robot().signed_distance({-1.0, 0.0}));
  EXPECT_EQ(dot(other.sides()[0].outward, other.sides()[0].segment.from) > 0.0,
            dot(long_robot().sides()[0].outward, long_robot().sides()[0].segment.from) > 0.0);
}

TEST(Outline, OnlyCornersThatStickOutAreRounded) {
  EXPECT_EQ(long_robot().round_corners().size(), 4u);
  EXPECT_EQ(fork().round_corners().size(), 6u);
}

TEST(Outline, ACircleThatTurnsReachesNowhereNew) {
  EXPECT_EQ(circle(0.2).reach(), 0.2);
  EXPECT_EQ(circle(0.2).turning_reach(), 0.0);
  EXPECT_NEAR(long_robot().turning_reach(), std::hypot(2.0, 0.1), 1e-12);
}

TEST(Outline, TheFastestPointIsFarthestFromTheCentreOfRotation) {
  EXPECT_NEAR(fastest_point(long_robot(), {0.5, 0.0, 0.0}), 0.5, 1e-12);
  EXPECT_NEAR(fastest_point(long_robot(), {0.0, 0.0, -2.0}), 2.0 * std::hypot(2.0, 0.1), 1e-12);
  EXPECT_NEAR(fastest_point(circle(0.2), {0.3, 0.4, -1.0}), 0.7, 1e-12);
  EXPECT_EQ(fastest_point(long_robot(), {}), 0.0);
}

TEST(Outline, OfNoFootprintThereIsNone) {
  try {
    Outline({{{0, 0}, {1, 0}}, 0.0, -1.0});
    FAIL();
  } catch (const std::invalid_argument& refusal) {
    EXPECT_STREQ(refusal.what(), "the polygon must have at least 3 corners; margin must lie between 0 and 100 m");
  }
}

}  // namespace
}  // namespace safety_control_cloud
