// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/pose.hpp"

#include <gtest/gtest.h>

#include "driving_odometry.hpp"

namespace safety_control_cloud {
namespace {

TEST(Pose, APartGoesItsOwnWay) {
  const double time = 0.8;
  for (const Twist2& twist : {Twist2{0.3, 0.1, 0.7}, Twist2{0.0, 0.0, -1.5}, Twist2{0.4, 0.0, 0.0}}) {
    for (const Pose2& part : {Pose2{{0.4, 0.0}, 0.0}, Pose2{{-0.2, 0.3}, 2.5}, Pose2{}}) {
      const Pose2 way = between(part, beyond(way_of(twist, time), part));
      expect_near(way_of(twist_of_part(twist, part), time), way, 1e-12);
    }
  }
}

TEST(Pose, AWayIsSeenBackwardByARestingPoint) {
  const Twist2 twist{0.3, 0.1, 0.7};
  const Point2 point{1.0, -0.5};
  const Point2 carried = SeenAfter(way_of(twist, 0.8))(point), direct = moved(point, twist, 0.8);
  EXPECT_NEAR(carried.x, direct.x, 1e-12);
  EXPECT_NEAR(carried.y, direct.y, 1e-12);
}

}  // namespace
}  // namespace safety_control_cloud
