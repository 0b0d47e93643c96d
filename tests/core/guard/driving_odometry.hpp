// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "../../../safety_control_cloud/core/guard/odometry.hpp"

namespace safety_control_cloud {

/// Says for `seconds` from `from` on where a robot is that keeps a twist from the origin on.
inline void drive(Odometry& odometry, const Twist2& twist, double from, double seconds) {
  for (int i = 0; i <= std::lround(seconds / 0.02); ++i) odometry.note(from + 0.02 * i, way_of(twist, 0.02 * i), twist);
}

inline void expect_near(const std::optional<Pose2>& way, const Pose2& expected, double tolerance) {
  ASSERT_TRUE(way);
  EXPECT_NEAR(way->place.x, expected.place.x, tolerance);
  EXPECT_NEAR(way->place.y, expected.place.y, tolerance);
  EXPECT_NEAR(way->heading, expected.heading, 1e-9);
}

}  // namespace safety_control_cloud
