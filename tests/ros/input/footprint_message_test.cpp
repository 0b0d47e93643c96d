// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/input/footprint_message.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <utility>

namespace safety_control_cloud {
namespace {

constexpr float odd = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();

geometry_msgs::PolygonStamped polygon_of(const std::vector<std::pair<float, float>>& corners) {
  geometry_msgs::PolygonStamped polygon;
  polygon.header.frame_id = "base_footprint";
  for (const auto& [x, y] : corners) {
    geometry_msgs::Point32 point;
    point.x = x, point.y = y;
    polygon.polygon.points.push_back(point);
  }
  return polygon;
}

TEST(FootprintMessage, KeepsItsCorners) {
  const auto lists =
      lists_in(footprint_in(polygon_of({{0.3f, 0.2f}, {-1e-7f, 0.25f}, {0.0f, -0.1f}}), "base_footprint"), 2);
  ASSERT_TRUE(lists);
  ASSERT_EQ(lists->size(), 3u);
  EXPECT_EQ(static_cast<float>((*lists)[0][0]), 0.3f);
  EXPECT_EQ(static_cast<float>((*lists)[1][0]), -1e-7f);
}

TEST(FootprintMessage, IsRefusedWhereItIsNoPolygonInBaseFrame) {
  const auto square = polygon_of({{1, 1}, {-1, 1}, {-1, -1}, {1, -1}});
  EXPECT_THROW(footprint_in(square, "base_link"), std::invalid_argument);
  EXPECT_THROW(footprint_in(polygon_of({}), "base_footprint"), std::invalid_argument);
  EXPECT_THROW(footprint_in(polygon_of({{1, 1}, {-1, 1}}), "base_footprint"), std::invalid_argument);
  EXPECT_THROW(footprint_in(polygon_of(std::vector<std::pair<float, float>>(101, {1, 1})), "base_footprint"),
               std::invalid_argument);
  for (const float bad : {odd, infinite, -infinite}) {
    EXPECT_THROW(footprint_in(polygon_of({{1, 1}, {-1, bad}, {-1, -1}}), "base_footprint"), std::invalid_argument);
    EXPECT_THROW(footprint_in(polygon_of({{bad, 1}, {-1, 1}, {-1, -1}}), "base_footprint"), std::invalid_argument);
  }
}

}  // namespace
}  // namespace safety_control_cloud
