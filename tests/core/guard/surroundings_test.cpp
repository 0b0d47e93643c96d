// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/surroundings.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "../../../safety_control_cloud/core/look/look.hpp"
#include "../../../safety_control_cloud/core/look/meaning.hpp"
#include "../input/cloud_builder.hpp"
#include "../path/footprints.hpp"

namespace safety_control_cloud {
namespace {

void look(Surroundings& seen, const std::vector<Xyz>& points, const Outlook& outlook) {
  const Alongside alongside = seen.begin(outlook);
  look_alongside(view_of(points), outlook, Crop::Skip, Rows::Joined, &alongside);
  seen.finish();
}

/// Points of base_frame, whose optical frame lies in its origin: x = -left, y = -up, z = forward.
Xyz at(float forward, float left, float up) { return {-left, -up, forward}; }

Outlook in_origin() { return {Corridor{}, Placement{}}; }

Surroundings around(std::vector<OwnBox> self = {}) { return {circle(0.2, 0.05), {0.05, 0.55, 4.0, std::move(self)}}; }

std::size_t returns_in(const Surroundings& surroundings) {
  std::size_t all = 0;
  for (const Ring& ring : surroundings.rings()) all += ring.returns;
  return all;
}

TEST(Surroundings, WhatLiesOutsideTheBandDoesNotCount) {
  Surroundings seen = around();
  const std::vector<Xyz> points = {at(1, 0, 0.04f), at(1, 0, 0.05f), at(1, 0, 0.55f), at(1, 0, 0.56f),
                                   at(1, 5, 0.3f),  {nan, nan, nan}, {0, 0, inf},     at(3, 3, 0.3f)};
  look(seen, points, in_origin());
  EXPECT_EQ(returns_in(seen), 3u);
}

/// By what a point means one at a time, whichever points are left out at once.
std::size_t counted_one_by_one(const std::vector<Xyz>& points, const Outlook& outlook, const Surroundings& seen) {
  const auto extent = static_cast<float>(seen.rings().back().extent);
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const Xyz& point) {
    const Point placed = outlook.placed(point.x, point.y, point.z);
    return is_return(point.x, point.y, point.z, outlook.corridor) && -placed.y >= 0.05f && -placed.y <= 0.55f &&
           std::abs(placed.z) < extent && std::abs(placed.x) < extent;
  }));
}

TEST(Surroundings, CountsToAllSidesWhatPointByPointCounts) {
  std::mt19937 random(20261122);
  std::uniform_real_distribution<float> anywhere(-5.0f, 5.0f), height(-0.7f, 0.1f), turn(-3.2f, 3.2f);
  const std::vector<float> odd = {nan, inf, -inf, 0.0f, -0.05f, -0.55f, 4.0f, -4.0f, 1e30f};
  for (int times = 0; times < 50; ++times) {
    std::vector<Xyz> points;
    for (int i = 0; i < 1500; ++i) points.push_back({anywhere(random), height(random), anywhere(random)});
    for (Xyz& point : points) {
      if (random() % 8 == 0) (&point.x)[random() % 3] = odd[random() % odd.size()];
    }
    Outlook outlook = in_origin();
    const Eigen::Matrix3f turned =
        (Eigen::AngleAxisf(turn(random), Eigen::Vector3f::UnitY()) * Eigen::AngleAxisf(0.1f, Eigen::Vector3f::UnitX()))
            .toRotationMatrix();
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) outlook.placement->rows[row][column] = turned(row, column);
    Surroundings seen = around();
    look(seen, points, outlook);
    EXPECT_EQ(returns_in(seen), counted_one_by_one(points, outlook, seen));
    look(seen, points, {outlook.corridor, std::nullopt});
    EXPECT_EQ(returns_in(seen), counted_one_by_one(points, {outlook.corridor, std::nullopt}, seen));
  }
}

TEST(Surroundings, WhatIsOfTheRobotItselfIsCutOut) {
  Surroundings seen = around({{0.9, 1.1, -0.1, 0.1, 0.2, 0.4}});
  const std::vector<Xyz> points = {at(1, 0, 0.3f), at(1, 0, 0.5f), at(1, 0.2f, 0.3f)};
  look(seen, points, in_origin());
  EXPECT_EQ(returns_in(seen), 2u);
}

TEST(Surroundings, EachLookForgetsTheOneBefore) {
  Surroundings seen = around();
  const std::vector<Xyz> some = {at(1, 0, 0.3f), at(0.3f, 0, 0.3f), at(3, 0, 0.3f)}, none = {at(1, 0, 3.0f)};
  look(seen, some, in_origin());
  EXPECT_EQ(returns_in(seen), 3u);
  look(seen, none, in_origin());
  EXPECT_EQ(returns_in(seen), 0u);
  EXPECT_TRUE(seen.rings().front().obstacles.points.empty());
}

TEST(Surroundings, NoReturnIsFartherFromItsPointThanIsSaid) {
  std::mt19937 random(20261122);
  std::uniform_real_distribution<float> ahead(0.01f, 3.9f), beside(-3.9f, 3.9f);
  std::vector<Xyz> points;
  for (int i = 0; i < 20000; ++i) points.push_back(at(ahead(random), beside(random), 0.3f));
  Surroundings seen = around();
  look(seen, points, in_origin());
  EXPECT_EQ(returns_in(seen), points.size());
  EXPECT_LE(seen.rings().front().obstacles.widening, 0.004);
  for (std::size_t i = 0; i < points.size(); i += 37) {
    const Point2 point{points[i].z, -points[i].x};
    bool near = false;
    for (const Ring& ring : seen.rings()) {
      for (const Point2& middle : ring.obstacles.points)
        near = near || length_of(point - middle) <= ring.obstacles.widening + 1e-6;
    }
    ASSERT_TRUE(near) << point.x << " " << point.y;
  }
}

TEST(Surroundings, AllThatIsInsideTheMarginLiesInTheInnermostRing) {
  Surroundings seen = around();
  const std::vector<Xyz> points = {at(0.2f, 0.1f, 0.3f), at(0.01f, -0.24f, 0.3f), at(0.6f, 0, 0.3f)};
  look(seen, points, in_origin());
  EXPECT_EQ(seen.rings().front().returns, 2u);
}

}  // namespace
}  // namespace safety_control_cloud
