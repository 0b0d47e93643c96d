// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/look/nearest.hpp"

#include <gtest/gtest.h>

#include "../input/cloud_builder.hpp"

namespace safety_control_cloud {
namespace {

Cloud cloud_at(const std::vector<float>& depths) {
  Cloud cloud;
  for (const float z : depths) cloud.push_back(Point(static_cast<float>(cloud.size()), 0.0f, z));
  return cloud;
}

TEST(Nearest, IsTheOneWithEnoughBeforeIt) {
  const Cloud cloud = cloud_at({3.0f, 1.0f, 2.0f});
  EXPECT_EQ(nearest_of(0, cloud, 1)->distance(), 1.0);
  EXPECT_EQ(nearest_of(0, cloud, 2)->distance(), 2.0);
  EXPECT_EQ(nearest_of(0, cloud, 3)->distance(), 3.0);
  EXPECT_FALSE(nearest_of(0, cloud, 4));
}

TEST(Nearest, WhatIsTooCloseComesFirst) {
  const Cloud cloud = cloud_at({3.0f, 1.0f});
  EXPECT_EQ(nearest_of(1, cloud, 2)->distance(), 1.0) << "the second of three";
  EXPECT_EQ(nearest_of(2, cloud, 2)->distance(), 0.0);
  EXPECT_EQ(nearest_of(1, {}, 1)->distance(), 0.0) << "nothing else need be there";
}

TEST(Nearest, OfEqualsItIsTheFirst) {
  EXPECT_EQ(nearest_of(0, cloud_at({2.0f, 1.0f, 1.0f}), 1)->point.x, 1.0f);
  EXPECT_EQ(nearest_of(0, cloud_at({2.0f, 1.0f, 1.0f}), 2)->point.x, 1.0f);
}

TEST(Nearest, BeyondTheLastRankThereIsNothing) {
  EXPECT_EQ(ranked({}, 0), inf);
  EXPECT_EQ(ranked({2.0f, 1.0f}, 1), 2.0f);
  EXPECT_EQ(ranked({2.0f, 1.0f}, 2), inf);
}

}  // namespace
}  // namespace safety_control_cloud
