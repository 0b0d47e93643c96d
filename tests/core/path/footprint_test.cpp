// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/path/footprint.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace safety_control_cloud {
namespace {

using Sentences = std::vector<std::string>;

Sentences problems_of(std::vector<Point2> corners) { return problems_in({std::move(corners), 0.0, 0.0}); }

TEST(Footprint, SquareCircleAndFarAwayTriangleAreFit) {
  EXPECT_EQ(problems_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), Sentences{});
  EXPECT_EQ(problems_of({{0, 1}, {1, 1}, {1, 0}, {0, 0}}), Sentences{});
  EXPECT_EQ(problems_of({{50, 50}, {51, 50}, {50, 51}}), Sentences{});
  EXPECT_EQ(problems_in({{}, 0.2, 0.05}), Sentences{});
}

TEST(Footprint, ACornerInTheMiddleOfASideIsFit) {
  EXPECT_EQ(problems_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}), Sentences{});
}

TEST(Footprint, NeitherPolygonNorRadiusIsNone) {
  const Sentences expected{"the footprint must have a polygon, or a radius of more than 0 and at most 100 m"};
  EXPECT_EQ(problems_in({}), expected);
  EXPECT_EQ(problems_in({{}, -1.0, 0.0}), expected);
  EXPECT_EQ(problems_in({{}, NAN, 0.0}), expected);
}

TEST(Footprint, BothAtOnceAreNone) {
  EXPECT_EQ(problems_in({{{0, 0}, {1, 0}, {0, 1}}, 0.5, 0.0}),
            Sentences{"the footprint is either a polygon or a radius"});
}

TEST(Footprint, AMarginIsFiniteAndNotNegative) {
  for (const double margin : {-0.1, static_cast<double>(NAN), static_cast<double>(INFINITY)})
    EXPECT_EQ(problems_in({{}, 0.2, margin}), Sentences{"margin must lie between 0 and 100 m"});
}

TEST(Footprint, TwoCornersAreNoPolygon) {
  EXPECT_EQ(problems_of({{0, 0}, {1, 0}}), Sentences{"the polygon must have at least 3 corners"});
}

TEST(Footprint, MillimetresAreNotMetres) {
  const Sentences expected{"each corner must be finite and within 100 m of base_frame's origin"};
  EXPECT_EQ(problems_of({{0, 0}, {350, 0}, {350, 350}}), expected);
  EXPECT_EQ(problems_of({{0, 0}, {1, NAN}, {1, 1}}), expected);
  EXPECT_EQ(problems_of({{0, 0}, {INFINITY, 0}, {1, 1}}), expected);
}

TEST(Footprint, ASideHasALength) {
  EXPECT_EQ(problems_of({{0, 0}, {1, 0}, {1, 0}, {0, 1}}),
            Sentences{"the side from corner 2 to corner 3 has no length"});
  EXPECT_EQ(problems_of({{0, 0}, {1, 0}, {0, 1}, {0, 0}}),
            Sentences{"the side from corner 4 to corner 1 has no length"});
}

TEST(Footprint, SidesDoNotCrossEachOther) {
  EXPECT_EQ(problems_of({{0, 0}, {1, 1}, {1, 0}, {0, 1}}),
            Sentences{"the side from corner 1 to corner 2 and the side from corner 3 to corner 4 meet"});
}

TEST(Footprint, SidesDoNotTouchEachOther) {
  EXPECT_EQ(problems_of({{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}}).front(),
            "the side from corner 1 to corner 2 and the side from corner 3 to corner 4 meet");
}

TEST(Footprint, APolygonDoesNotFoldBackOnItself) {
  EXPECT_FALSE(problems_of({{0, 0}, {1, 0}, {2, 0}}).empty());
  EXPECT_EQ(problems_of({{0, 0}, {2, 0}, {2, 1}, {2, 0.5}, {0, 1}}).front(), "the polygon folds back at corner 3");
}

}  // namespace
}  // namespace safety_control_cloud
