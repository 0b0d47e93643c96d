// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/speed/straying.hpp"

#include <gtest/gtest.h>

#include "../path/footprints.hpp"

namespace safety_control_cloud {
namespace {

Straying straying_of(const Twist2& under_way, const Twist2& wanted, const Factors& factors = {0.0, 1.0}) {
  return straying(circle(0.2, 0.05), Law{}, response_to(Law{}, {}, wanted), under_way, wanted, factors);
}

TEST(Straying, WhoDrivesThePathAlreadyDoesNotLeaveIt) {
  const Straying same = straying_of({0.3, 0.0, 0.0}, {0.3, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(same.share, 1.0);
  EXPECT_NEAR(same.widening, 0.0, 1e-12);
  const Straying half = straying_of({0.15, 0.0, 0.0}, {0.3, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(half.share, 0.5);
  EXPECT_NEAR(half.widening, 0.0, 1e-12);
}

/// At once it could not be shed: 0.2 m/s for latency and reaction, 0.15 s, and while it brakes.
TEST(Straying, WhatIsAcrossThePathMustBeShed) {
  const Straying across = straying_of({0.0, 0.2, 0.0}, {0.3, 0.0, 0.0});
  EXPECT_EQ(across.share, 0.0);
  EXPECT_GT(across.widening, 0.2 * 0.15 + 0.5 * 0.2 * 0.2 / 0.36);
  EXPECT_GT(straying_of({0.0, 0.4, 0.0}, {0.3, 0.0, 0.0}).widening, across.widening);
}

TEST(Straying, BackwardIsNoShareOfForward) {
  const Straying backward = straying_of({-0.2, 0.0, 0.0}, {0.3, 0.0, 0.0});
  EXPECT_EQ(backward.share, 0.0);
  EXPECT_GT(backward.widening, 0.0);
}

TEST(Straying, AxesThatBrakeOutOfStepLeaveThePath) {
  EXPECT_NEAR(straying_of({0.0, 0.0, 0.0}, {0.3, 0.0, 0.0}, {0.0, 1.0}).widening, 0.0, 1e-12) << "of one axis";
  EXPECT_GT(straying_of({0.0, 0.0, 0.0}, {0.3, 0.0, 1.0}, {0.0, 1.0}).widening, 0.0);
}

}  // namespace
}  // namespace safety_control_cloud
