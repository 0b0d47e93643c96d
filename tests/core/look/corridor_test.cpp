// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "../../../safety_control_cloud/core/look/look.hpp"
#include "../../../safety_control_cloud/core/look/passthrough.hpp"
#include "../input/cloud_builder.hpp"

namespace safety_control_cloud {
namespace {

using Look = Sight (*)(const View&, const Outlook&, Crop, Rows);

/// Both methods must pass every test: what holds for one holds for the other.
class Corridors : public testing::TestWithParam<Look> {
 protected:
  Sight see(const std::vector<Xyz>& points, const Corridor& corridor = {}) const {
    return GetParam()(view_of(points), corridor, Crop::Keep, Rows::Joined);
  }
};

INSTANTIATE_TEST_SUITE_P(By, Corridors, testing::Values(&look, &passthrough),
                         [](const auto& info) { return info.index == 0 ? "OnePass" : "Pcl"; });

TEST_P(Corridors, NearestObstacleIsTheSmallestDepthInside) {
  const Sight sight = see({{0.0f, 0.0f, 2.0f}, {0.1f, 0.1f, 0.7f}, {5.0f, 0.0f, 0.2f}});
  ASSERT_TRUE(sight.nearest);
  EXPECT_EQ(sight.nearest->distance(), double{0.7f});
  EXPECT_EQ(sight.nearest->point.x, 0.1f);
  EXPECT_EQ(sight.inside, std::size_t{2});
  EXPECT_EQ(sight.returns, std::size_t{3});
  EXPECT_EQ(sight.total, std::size_t{3});
}

TEST_P(Corridors, NothingInsideIsNoObstacleAndNoDistance) {
  const Sight sight = see({{5.0f, 0.0f, 0.2f}});
  EXPECT_FALSE(sight.nearest);
  EXPECT_EQ(sight.returns, std::size_t{1});
}

TEST_P(Corridors, EmptyCloudHasNoReturns) {
  const Sight sight = see({});
  EXPECT_FALSE(sight.nearest);
  EXPECT_EQ(sight.total, std::size_t{0});
}

TEST_P(Corridors, PointsOnTheLimitsAreInside) {
  const Corridor c;
  EXPECT_EQ(see({{c.x_min, 0, 1}, {c.x_max, 0, 1}, {0, c.y_min, 1}, {0, c.y_max, 1}}).inside, std::size_t{4});
}

TEST_P(Corridors, PointsOneFloatBeyondTheLimitsAreOutside) {
  const Corridor c;
  const std::vector<Xyz> points = {{std::nextafter(c.x_min, -inf), 0, 1},
                                   {std::nextafter(c.x_max, inf), 0, 1},
                                   {0, std::nextafter(c.y_min, -inf), 1},
                                   {0, std::nextafter(c.y_max, inf), 1}};
  EXPECT_EQ(see(points).inside, std::size_t{0});
}

TEST_P(Corridors, ZerosNansAndFarInfinitiesAreNoReturns) {
  const Sight sight = see({{0, 0, 0},
                           {0, 0, -0.0f},
                           {nan, nan, nan},
                           {nan, 0, 1},
                           {0, nan, 1},
                           {0, 0, nan},
                           {0, 0, inf},
                           {inf, 0, 1},
                           {0, -inf, 1},
                           {0, 0, -1}});
  EXPECT_EQ(sight.returns, std::size_t{0});
  EXPECT_EQ(sight.too_close, std::size_t{0});
  EXPECT_FALSE(sight.nearest);
  EXPECT_EQ(sight.total, std::size_t{10});
}

TEST_P(Corridors, TooCloseIsAnObstacleAtDistanceZero) {
  for (const Xyz& point : {Xyz{nan, nan, -inf}, Xyz{0, 0, -inf}, Xyz{-inf, -inf, -inf}, Xyz{nan, 0.1f, -inf}}) {
    const Sight sight = see({{0, 0, 2}, point});
    ASSERT_TRUE(sight.nearest);
    EXPECT_EQ(sight.nearest->distance(), 0.0);
    EXPECT_EQ(sight.too_close, std::size_t{1});
    EXPECT_EQ(sight.returns, std::size_t{1});
  }
}

TEST_P(Corridors, TooCloseBesideTheCorridorIsNoObstacle) {
  EXPECT_EQ(see({{0.4f, nan, -inf}, {nan, 0.3f, -inf}, {-0.4f, 0, -inf}}).too_close, std::size_t{0});
}

TEST_P(Corridors, OneNoisePointIsNoObstacleWhereTwoPointsMakeOne) {
  Corridor corridor;
  corridor.min_points = 2;
  EXPECT_FALSE(see({{0, 0, 0.3f}}, corridor).nearest);
  EXPECT_EQ(see({{0, 0, 0.3f}, {0, 0, 0.9f}, {0, 0, 0.8f}}, corridor).nearest->distance(), double{0.8f});
}

TEST_P(Corridors, EqualDistancesCountAsSoManyPoints) {
  Corridor corridor;
  corridor.min_points = 2;
  const Sight sight = see({{0.2f, 0, 0.8f}, {0.1f, 0, 0.8f}}, corridor);
  EXPECT_EQ(sight.nearest->distance(), double{0.8f});
  EXPECT_EQ(sight.nearest->point.x, 0.2f) << "of equals, the first in the cloud";
}

TEST_P(Corridors, TooClosePointsCountTowardsMinPoints) {
  Corridor corridor;
  corridor.min_points = 2;
  EXPECT_EQ(see({{nan, nan, -inf}, {0, 0, 0.9f}}, corridor).nearest->distance(), double{0.9f});
  EXPECT_EQ(see({{nan, nan, -inf}, {nan, nan, -inf}}, corridor).nearest->distance(), 0.0);
}

TEST_P(Corridors, NothingWithinRangeMinIsAReturn) {
  Corridor corridor;
  corridor.range_min = 0.4f;
  const Sight sight = see({{0, 0, 0.4f}, {0, 0, std::nextafter(0.4f, 1.0f)}}, corridor);
  EXPECT_EQ(sight.returns, std::size_t{1});
}

TEST_P(Corridors, CropHoldsTheInsidePointsInTheCloudsOrder) {
  const Sight sight = see({{0.1f, 0, 3}, {9, 0, 1}, {0.2f, 0, 1}, {nan, 0, 1}, {0.3f, 0, 2}});
  ASSERT_TRUE(sight.crop);
  ASSERT_EQ(sight.crop->size(), std::size_t{3});
  EXPECT_EQ(sight.crop->points[0].z, 3.0f);
  EXPECT_EQ(sight.crop->points[1].z, 1.0f);
  EXPECT_EQ(sight.crop->points[2].z, 2.0f);
}

TEST_P(Corridors, NoCropIsMadeUnlessAskedFor) {
  const std::vector<Xyz> points = {{0, 0, 1}};
  EXPECT_FALSE(GetParam()(view_of(points), {}, Crop::Skip, Rows::Joined).crop);
}

TEST_P(Corridors, FarDoubleStaysAFarFiniteNumber) {
  const std::vector<double> points = {0, 0, 1e300, 0, 0, -1e300, 1e300, 0, 0.5};
  CloudView view;
  view.bytes = reinterpret_cast<const std::uint8_t*>(points.data());
  view.width = 3, view.height = 1, view.point_step = 24, view.row_step = 72, view.offset = {0, 8, 16};
  view.scalar = Scalar::Float64;
  const Sight sight = GetParam()(view, {}, Crop::Skip, Rows::Joined);
  EXPECT_EQ(sight.returns, std::size_t{2});
  EXPECT_EQ(sight.too_close, std::size_t{0}) << "a finite number is not REP 117's -Inf";
  EXPECT_EQ(sight.nearest->distance(), double{std::numeric_limits<float>::max()});
}

TEST_P(Corridors, PlacedCorridorLooksForwardFromItsOwnFrame) {
  Placement
      placement;  // a camera 0.1 m behind the frame's origin and 0.3 m above it, turned to the right by 90 degrees
  placement.rows = {{{0, 0, 1, 0}, {0, 1, 0, -0.3f}, {-1, 0, 0, -0.1f}}};
  const std::vector<Xyz> points = {{-0.9f, 0.2f, 0.1f}, {0.5f, 0.2f, 0.1f}, {-0.9f, 0.2f, 1.0f}, {0, 0, 0}};
  const Sight sight = GetParam()(view_of(points), Outlook({}, placement), Crop::Keep, Rows::Joined);
  EXPECT_EQ(sight.returns, std::size_t{3}) << "(0, 0, 0) of the sensor is no return wherever the sensor is";
  EXPECT_EQ(sight.inside, std::size_t{1}) << "one is behind the frame's origin, one beside the corridor";
  EXPECT_FLOAT_EQ(sight.nearest->point.x, 0.1f);
  EXPECT_FLOAT_EQ(sight.nearest->point.y, -0.1f);
  EXPECT_FLOAT_EQ(sight.nearest->point.z, 0.8f);
  EXPECT_EQ(sight.crop->points[0].x, -0.9f) << "the crop stays in the cloud's frame";
}

TEST_P(Corridors, NearestOfEachRowIsToldWhereRowsAreToldApart) {
  const std::vector<Xyz> points = {{0, 0, 2}, {0, 0, 0.5f}, {0.4f, 0, 0.6f}, {nan, nan, nan}, {0, 0, 3}, {0, 0.25f, 1}};
  CloudView view = view_of(points);
  view.width = 2, view.height = 3, view.row_step = 2 * sizeof(Xyz);
  EXPECT_TRUE(GetParam()(view, {}, Crop::Skip, Rows::Joined).nearest_in_rows.empty());
  EXPECT_EQ(GetParam()(view, {}, Crop::Skip, Rows::Apart).nearest_in_rows, (std::vector<float>{0.5f, inf, 3.0f}));
}

}  // namespace
}  // namespace safety_control_cloud
