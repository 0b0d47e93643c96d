// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/look/placement.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace safety_control_cloud {
namespace {

using Matrix = Eigen::Matrix<double, 3, 4>;

TEST(Placement, AxesOfTheRobotBecomeThoseOfTheCorridor) {
  Matrix place = Matrix::Identity();
  place.col(3) << 0.1, 0.2, 0.3;  // the cloud lies in a frame of the robot's axes, moved
  const Point point = std::get<Placement>(placing_of(place))(1.0f, 0.5f, 0.25f);
  EXPECT_FLOAT_EQ(point.x, -0.7f) << "right is not left";
  EXPECT_FLOAT_EQ(point.y, -0.55f) << "down is not up";
  EXPECT_FLOAT_EQ(point.z, 1.1f) << "forward";
}

TEST(Placement, OpticalFrameThatLooksForwardStaysAsItIs) {
  Matrix place;
  place << 0, 0, 1, 0, -1, 0, 0, 0, 0, -1, 0, 0;
  const Point point = std::get<Placement>(placing_of(place))(1.0f, 2.0f, 3.0f);
  EXPECT_EQ(point.x, 1.0f);
  EXPECT_EQ(point.y, 2.0f);
  EXPECT_EQ(point.z, 3.0f);
}

TEST(Placement, OneThatIsNotFiniteIsNone) {
  for (const double odd : {NAN, INFINITY}) {
    Matrix place = Matrix::Identity();
    place(1, 3) = odd;
    EXPECT_TRUE(std::holds_alternative<NoTransform>(placing_of(place)));
  }
}

}  // namespace
}  // namespace safety_control_cloud
