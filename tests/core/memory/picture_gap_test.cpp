// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/picture_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace safety_control_cloud {
namespace {

constexpr double stamp = 1.7e9, came = 1000.0;  // [s]
constexpr double source_timeout = 0.5;          // [s]

/// [s] between one picture and another with such a stamp that comes so much later.
double between(double stamps, double arrivals, double timeout = source_timeout) {
  PictureGap gap;
  gap.note(stamp, came, timeout);
  return gap.note(stamp + stamps, came + arrivals, timeout);
}

TEST(PictureGap, BeforeTheFirstNobodyLooked) {
  EXPECT_TRUE(std::isinf(PictureGap().note(stamp, came, source_timeout)));
}

TEST(PictureGap, StampsTellWhenPicturesWereTaken) {
  EXPECT_NEAR(between(0.1, 0.1), 0.1, 1e-6);
  EXPECT_NEAR(between(0.1, 0.2), 0.1, 1e-6) << "a busy computer";
  EXPECT_NEAR(between(0.7, 0.001), 0.7, 1e-6) << "the one before had waited in a queue";
}

TEST(PictureGap, ACameraMayStallWhileItsStampsGoOnEvenly) { EXPECT_NEAR(between(0.033, 0.7), 0.7, 1e-6); }

TEST(PictureGap, AReplayThatDoesNotWaitIsAsFastAsItsRecording) {
  EXPECT_NEAR(between(0.1, 3.0, 10.0), 0.1, 1e-6);
  EXPECT_NEAR(between(3.0, 0.1, 10.0), 3.0, 1e-6);
}

TEST(PictureGap, StampsThatDoNotGoForwardTellNothing) {
  for (const double forward : {0.0, -0.1, -stamp, 1e-9, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_NEAR(between(forward, 0.1), 0.1, 1e-6) << forward;
    EXPECT_NEAR(between(forward, 0.7), 0.7, 1e-6) << forward;
  }
}

TEST(PictureGap, EachIsToldFromTheOneBefore) {
  PictureGap gap;
  gap.note(stamp, came, source_timeout);
  EXPECT_NEAR(gap.note(stamp + 0.1, came + 0.1, source_timeout), 0.1, 1e-6);
  EXPECT_NEAR(gap.note(stamp + 0.15, came + 0.15, source_timeout), 0.05, 1e-6);
}

}  // namespace
}  // namespace safety_control_cloud
