// SPDX-License-Identifier: BSD-3-Clause
// What no twist explains of the way that odometry tells of.
#include <gtest/gtest.h>

#include <algorithm>

#include "driving_odometry.hpp"

namespace safety_control_cloud {
namespace {

TEST(Odometry, TellsWhatNoTwistExplains) {
  Odometry odometry;
  drive(odometry, {0.4, 0.0, 0.5}, 10.0, 1.0);
  EXPECT_EQ(odometry.unexplained_until(11.0).place, 0.0);
  const Pose2 there = way_of({0.4, 0.0, 0.5}, 1.0);
  for (int i = 1; i <= 3; ++i)
    odometry.note(11.0 + 0.02 * i, {{there.place.x + 0.09 * i, there.place.y}, there.heading}, {});
  EXPECT_EQ(odometry.breaks(), std::size_t{0});
  EXPECT_NEAR(odometry.unexplained_until(11.06).place, 3 * 0.09 - 1.25 * 0.02 * 0.4, 1e-6);
  EXPECT_NEAR(odometry.unexplained_until(11.03).place, 0.09 - 1.25 * 0.02 * 0.4, 1e-6) << "between two of them";
  EXPECT_EQ(odometry.unexplained_until(11.06).heading, 0.0);
  EXPECT_EQ(odometry.unexplained_until(10.5).place, 0.0);
}

TEST(Odometry, NoiseOfAPoseIsExplained) {
  Odometry odometry;
  for (int i = 0; i < 500; ++i) odometry.note(10.0 + 0.02 * i, {{0.004 * (i % 2), 0.0}, -0.004 * (i % 2)}, {});
  EXPECT_EQ(odometry.unexplained_until(20.0).place, 0.0);
  EXPECT_EQ(odometry.unexplained_until(20.0).heading, 0.0);
}

/// As if corrected by and by, and told fifty times a second.
TEST(Odometry, TellsWhatNoTwistExplainsThoughItSlewsByNoMoreThanNoiseAtATime) {
  for (const double slew : {0.001, 0.003, 0.009}) {
    Odometry odometry;
    drive(odometry, {0.3, 0.0, 0.0}, 10.0, 1.0);
    for (int i = 1; i <= 120; ++i) odometry.note(11.0 + 0.02 * i, {{0.3, slew * i}, slew * i}, {});
    EXPECT_EQ(odometry.breaks(), std::size_t{0});
    const Drift all = odometry.unexplained_until(13.4), earlier = odometry.unexplained_until(12.0);
    EXPECT_NEAR(all.place, 120 * slew, 0.35 * 120 * slew) << slew;
    EXPECT_NEAR(all.heading, 120 * slew, 0.35 * 120 * slew) << slew;
    EXPECT_LT(earlier.place, all.place) << slew;
  }
}

/// As TF has it.
TEST(Odometry, OfPosesAloneWhatTheBaseWasNotToldIsNotExplained) {
  const auto after = [](double turn, double told) {
    Odometry odometry;
    for (int i = 0; i < 10; ++i) odometry.note_pose(10.0 + 0.2 * i, {}, {0.0, told});
    odometry.note_pose(12.0, {{0.0, 0.0}, turn}, {0.0, told});
    return odometry;
  };
  EXPECT_EQ(after(0.58, 0.0).breaks(), std::size_t{1});
  EXPECT_EQ(after(0.09, 0.0).breaks(), std::size_t{0});
  EXPECT_NEAR(after(0.09, 0.0).unexplained_until(12.0).heading, 0.09, 1e-6);
  EXPECT_EQ(after(0.24, 1.0).breaks(), std::size_t{0}) << "told to turn";
  EXPECT_EQ(after(0.24, 1.0).unexplained_until(12.0).heading, 0.0);
}

TEST(Odometry, WhoLeavesTheTwistsZeroIsNotBelievedToGoOnFasterThanTheBaseWasTold) {
  for (const double told : {0.0, 0.5}) {
    Odometry odometry;
    for (int i = 0; i <= 100; ++i) odometry.note(10.0 + 0.02 * i, {{0.008 * i, 0.0}, 0.0}, {}, {told, told});
    if (told == 0.0)
      EXPECT_NEAR(odometry.unexplained_until(12.0).place, 0.8, 0.05);
    else
      EXPECT_LT(odometry.unexplained_until(12.0).place, 0.03);
  }
}

/// As some bases leave them zero.
TEST(Odometry, WhoTellsNoTwistsIsBelievedAsLongAsHeGoesOnAsBefore) {
  for (const double period : {0.02, 0.1}) {
    Odometry odometry;
    double x = 0.0, speed = 0.0, stamp = 10.0;
    for (; stamp < 14.0; stamp += period) {
      speed = std::min(0.6, speed + 0.5 * period);
      x += speed * period;
      odometry.note(stamp, {{x, 0.0}, 0.3 * x}, {});
    }
    EXPECT_EQ(odometry.breaks(), std::size_t{0}) << period;
    EXPECT_LT(odometry.unexplained_until(14.0).place, 0.05) << period;
    odometry.note(stamp, {{x + speed * period, 0.09}, 0.3 * x}, {});
    EXPECT_GT(odometry.unexplained_until(stamp).place, period < 0.05 ? 0.05 : 0.02) << period;
  }
}

}  // namespace
}  // namespace safety_control_cloud
