// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/guard.hpp"

#include <gtest/gtest.h>

#include <random>

#include "guarded_robot.hpp"

namespace safety_control_cloud {
namespace {

/// One return, as a sensor saw it before the robot went one of these ways.
double factor_of(const Guard& guard, const Twist2& wanted, const Point2& point, const std::vector<Pose2>& ways) {
  const std::vector<Ring> rings{{1.0, {{point}, {1}, 0.0}, 1}};
  Known known;
  known.rings = &rings;
  known.law.noise = 0.0;
  known.ways = ways;
  known.eye = Eye{{}, {1.0, 0.0}, 3.1};
  return guard.allowed(wanted, {}, {known}).factor;
}

/// A base that may have gone anything from nothing to so far, as one that has just been told to stand.
TEST(Guard, WhoMayHaveGoneAnyShareOfAWayIsLetDriveNoMoreThanWhoHasGoneIt) {
  std::mt19937 random(7);
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Settings settings = guard_settings();
  settings.footprint.text = "[[0.1, 0.05], [-0.08, 0.05], [-0.08, -0.05], [0.1, -0.05]]";
  const Guard guard(settings);
  int decided = 0;
  for (int i = 0; i < 20000; ++i) {
    const double turns = i % 2 == 0 ? 0.6 : 0.03;
    const Pose2 most{{within(-0.1, 0.9), within(-0.1, 0.1)}, within(-turns, turns)};
    const Twist2 wanted{i % 4 == 1 ? 0.0 : within(-0.7, 0.7), 0.0, within(-1.5, 1.5)};
    const Pose2 gone = shared(most, within(0.0, 1.0));
    const Point2 point = gone.place + within(0.1, 0.6) * turned({1.0, 0.0}, within(-3.2, 3.2));
    if (guard.outline().signed_distance(SeenAfter(gone)(point)) < guard.outline().margin()) continue;  // escape.hpp
    const double one = factor_of(guard, wanted, point, {gone});
    const double any = factor_of(guard, wanted, point, {{}, most});
    ASSERT_LE(any, one + 1e-9) << i << ": " << most.place.x << " " << most.place.y << " " << most.heading << ", "
                               << point.x << " " << point.y << ", " << wanted.vx << " " << wanted.w;
    decided += one < 1.0;
  }
  EXPECT_GT(decided, 1000);
}

}  // namespace
}  // namespace safety_control_cloud
