// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/speed/law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace safety_control_cloud {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Law, DefaultsAreFit) { EXPECT_TRUE(problems_in(Law{}).empty()); }

TEST(Law, EveryFigureIsChecked) {
  Law law;
  law.sensor_period = -1.0;
  law.linear_deceleration = 0.0;
  law.angular_deceleration = NAN;
  law.noise = infinity;
  law.min_points = 0;
  const std::vector<std::string> expected{"sensor_period must be finite and not negative",
                                          "linear_deceleration must be positive",
                                          "angular_deceleration must be positive",
                                          "noise must be finite and not negative", "min_points must be at least 1"};
  EXPECT_EQ(problems_in(law), expected);
}

TEST(Law, OldDataLengthensTheReaction) {
  Law law;
  law.sensor_period = 0.1, law.latency = 0.02, law.base_reaction = 0.03;
  EXPECT_DOUBLE_EQ(response_to(law, {0.01}, {}).reaction, 0.15);
  EXPECT_DOUBLE_EQ(response_to(law, {0.40}, {}).reaction, 0.45);
  EXPECT_DOUBLE_EQ(response_to(law, {0.40}, {}).delay, 0.05);
}

TEST(Law, WhatApproachesDoesSoUntilTheRobotStands) {
  Law law;
  law.sensor_period = 0.1, law.latency = 0.02, law.base_reaction = 0.03;
  law.linear_deceleration = 0.5, law.obstacle_speed = 0.2;
  const Twist2 wanted{0.5, 0.0, 0.0};  // 1 s of braking
  const auto nearer = [&](const Age& age, double factor, double share) {
    return approach(law, age, response_to(law, age, wanted), factor, share) / law.obstacle_speed;
  };
  EXPECT_DOUBLE_EQ(nearer({}, 0.5, 0.0), 0.15 + 0.5);
  for (const double age : {0.05, 0.10, 0.15})
    EXPECT_DOUBLE_EQ(nearer({age, 0.15}, 0.5, 0.0), 0.20 + 0.5) << "until the next look: what is given now, is then";
  EXPECT_DOUBLE_EQ(nearer({0.40, 0.15}, 0.5, 0.0), 0.45 + 0.5) << "which is late";
  EXPECT_DOUBLE_EQ(nearer({0.05, 0.15}, 0.0, 0.5), 0.10 + 0.5) << "who is told to brake does not wait for it";
  EXPECT_DOUBLE_EQ(nearer({0.05, 0.15}, 0.45, 0.5), 0.20 + 0.45) << "the later of both";
}

TEST(Law, TheSlowerAxisDecidesWhenTheRobotStands) {
  Law law;
  law.linear_deceleration = 0.5, law.angular_deceleration = 2.0;
  EXPECT_DOUBLE_EQ(response_to(law, {}, {0.3, 0.4, 1.0}).braking, 1.0);
  EXPECT_DOUBLE_EQ(response_to(law, {}, {0.3, 0.4, -4.0}).braking, 2.0);
}

TEST(Law, TheFactorUsesUpJustTheTimeThereIs) {
  for (const double reaction : {0.0, 1e-9, 0.2, 3.0}) {
    for (const double braking : {0.0, 1e-12, 0.5, 4.0}) {
      for (const double time : {1e-9, 0.01, 0.3, 1.7}) {
        const double factor = greatest_factor(time, {0.0, reaction, braking});
        ASSERT_GT(factor, 0.0);
        const double used = stopping_time(factor, reaction, braking);
        EXPECT_LE(used, time * (1.0 + 1e-12));
        EXPECT_TRUE(factor == 1.0 || used > time * (1.0 - 1e-12));
      }
    }
  }
}

TEST(Law, NoTimeIsStanding) {
  for (const double time : {0.0, -1.0, static_cast<double>(NAN)}) {
    EXPECT_EQ(greatest_factor(time, {0.1, 0.2, 0.5}), 0.0);
    EXPECT_EQ(greatest_factor(time, {0.0, 0.0, 0.0}), 0.0);
  }
}

TEST(Law, NoContactIsAllOfTheWish) {
  EXPECT_EQ(greatest_factor(infinity, {0.1, 0.2, 0.5}), 1.0);
  EXPECT_EQ(greatest_factor(1e-9, {0.0, 0.0, 0.0}), 1.0);
}

TEST(Law, WhoDrivesFasterThanTheFactorSlowsToLess) {
  const Response response{0.1, 0.2, 2.0};
  const double time = 0.5, from_rest = greatest_factor(time, response);
  EXPECT_EQ(greatest_factor(time, response, 0.9 * from_rest), from_rest);
  EXPECT_NEAR(greatest_factor(time, response, from_rest + 1e-9), from_rest, 1e-6);
  EXPECT_LT(greatest_factor(time, response, 1.02 * from_rest), from_rest);
  EXPECT_LT(greatest_factor(time, response, 1.04 * from_rest), greatest_factor(time, response, 1.02 * from_rest));
}

TEST(Law, WhoDrivesFasterEndsJustInTime) {
  const double delay = 0.1, reaction = 0.5, braking = 2.0, time = 0.5, share = 0.61;
  const double factor = greatest_factor(time, {delay, reaction, braking}, share);
  ASSERT_GT(factor, 0.0);
  ASSERT_LT(factor, share);
  const double slowing = (share - factor) * braking;
  ASSERT_LT(slowing, reaction - delay);
  const double used = share * delay + 0.5 * (share + factor) * slowing + factor * (reaction - delay - slowing) +
                      0.5 * factor * factor * braking;
  EXPECT_NEAR(used, time, 1e-12);
}

TEST(Law, TheLeastTimeIsThatFromWhichOnTheFactorIsGiven) {
  for (const Response& response : {Response{0.1, 0.2, 2.0}, Response{0.1, 0.5, 0.3}, Response{0.0, 0.0, 1.0}}) {
    for (const double share : {0.0, 0.3, 0.7, 1.0, 1.4}) {
      for (const double factor : {0.05, 0.27, 0.5, 0.9, 1.0}) {
        const double time = least_time(factor, response, share);
        EXPECT_GE(greatest_factor(time * (1.0 + 1e-9), response, share), factor * (1.0 - 1e-6)) << share;
        EXPECT_LT(greatest_factor(time * (1.0 - 1e-6), response, share), factor) << share << ", " << factor;
      }
      EXPECT_EQ(greatest_factor(least_time(0.0, response, share) * (1.0 - 1e-9), response, share), 0.0);
    }
  }
}

TEST(Law, WhoCannotStopInTimeBrakesAtOnce) {
  const Response response{0.1, 0.2, 2.0};
  EXPECT_EQ(greatest_factor(0.5, response, 0.7), 0.0);
  EXPECT_GT(greatest_factor(0.5, response, 0.6), 0.0);
}

}  // namespace
}  // namespace safety_control_cloud
