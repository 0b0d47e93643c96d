// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/input/to_cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cloud_builder.hpp"

namespace safety_control_cloud {
namespace {

TEST(ToCloud, EveryPointIsThereInItsOrderWhateverItHolds) {
  const std::vector<Xyz> points = {{1, 2, 3}, {nan, 0, 1}, {0, 0, -inf}, {0, 0, 0}, {4, 5, 6}, {7, 8, 9}};
  CloudView view = view_of(points);
  view.width = 3, view.height = 2, view.row_step = 3 * sizeof(Xyz);
  const Cloud cloud = to_cloud(view);
  EXPECT_EQ(cloud.width, 3u);
  EXPECT_EQ(cloud.height, 2u);
  EXPECT_FALSE(cloud.is_dense) << "PCL would not ask for NaN";
  ASSERT_EQ(cloud.size(), points.size());
  EXPECT_EQ(cloud.at(2, 0).z, -inf);
  EXPECT_TRUE(std::isnan(cloud.at(1, 0).x));
  EXPECT_EQ(cloud.at(2, 1).y, 8.0f);
}

TEST(ToCloud, PixelOfADepthImageIsThePointOnItsRay) {
  const std::vector<std::uint16_t> depths = {0, 2000};
  DepthView image;
  image.bytes = reinterpret_cast<const std::uint8_t*>(depths.data());
  image.width = 2, image.height = 1, image.row_step = 4, image.depth = Depth::Millimetres;
  image.camera = {2.0, 2.0, 0.0, 1.0};
  const Cloud cloud = to_cloud(image);
  ASSERT_EQ(cloud.size(), std::size_t{2});
  EXPECT_TRUE(std::isnan(cloud[0].z));
  EXPECT_NEAR(cloud[1].x, 1.0, 1e-6) << "(1 - 0) / 2 of 2 m";
  EXPECT_NEAR(cloud[1].y, -1.0, 1e-6) << "(0 - 1) / 2 of 2 m";
  EXPECT_NEAR(cloud[1].z, 2.0, 1e-6);
}

TEST(ToCloud, OfNothingIsEmpty) { EXPECT_TRUE(to_cloud(CloudView{}).empty()); }

}  // namespace
}  // namespace safety_control_cloud
