// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/extremes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace safety_control_cloud {
namespace {

constexpr Following slow{0.15, 0.5, 2.0};

struct Ahead {
  double least = 9.0, most = -9.0;  ///< [m]

  explicit Ahead(const Whereabouts& there) {
    for (const Pose2& one : there.or_else) least = std::min(least, one.place.x), most = std::max(most, one.place.x);
  }
};

TEST(Extremes, WhoMayAimAtOneTwistAloneWasDrivingItOrTookTimeToComeToIt) {
  Extremes extremes;
  const Twist2 ahead_alone{0.4, 0.0, 0.0};
  for (int i = 0; i < 200; ++i) extremes.go_on({ahead_alone, ahead_alone}, 0.01, slow);
  const Ahead ahead(extremes.whereabouts(0.1));
  EXPECT_NEAR(ahead.most, 0.8, 1e-9);
  EXPECT_NEAR(ahead.least, 0.8 - 0.4 * 0.4 / (2 * 0.5), 1e-9);
  EXPECT_NEAR(extremes.whereabouts(0.1).pose.place.x, 0.5 * (ahead.least + ahead.most), 1e-9);
}

TEST(Extremes, WhoMayStillStopMayCoastAsLongAsItTakes) {
  Extremes extremes;
  extremes.go_on({{}, {0.4, 0.0, 0.0}}, 0.1, slow);
  for (int i = 0; i < 200; ++i) extremes.go_on({}, 0.01, slow);
  const Ahead ahead(extremes.whereabouts(0.1));
  EXPECT_NEAR(ahead.most, 0.04 + 0.4 * 0.4 / (2 * 0.5), 1e-9);
  EXPECT_EQ(ahead.least, 0.0);
}

TEST(Extremes, ThereIsOneForEachSideOfEachAxis) {
  Extremes extremes;
  extremes.go_on({{-0.1, -0.2, -0.3}, {0.1, 0.2, 0.3}}, 0.01, slow);
  const Whereabouts there = extremes.whereabouts(0.1);
  ASSERT_EQ(there.or_else.size(), 8u);
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double w : {-1.0, 1.0}) {
        EXPECT_TRUE(std::any_of(there.or_else.begin(), there.or_else.end(), [&](const Pose2& one) {
          return one.place.x * x > 0.0 && one.place.y * y > 0.0 && one.heading * w > 0.0;
        }));
      }
    }
  }
}

}  // namespace
}  // namespace safety_control_cloud
