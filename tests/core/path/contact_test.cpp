// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/path/contact.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Obstacles obstacles_of(const std::vector<std::uint32_t>& counts) {
  return {std::vector<Point2>(counts.size()), counts, 0.0};
}

TEST(Contact, IsWithTheReturnThatMakesEnough) {
  const Obstacles alone{std::vector<Point2>(3), {}, 0.0};
  EXPECT_EQ(contact(alone, {3.0, 1.0, 2.0}, 1).time, 1.0);
  EXPECT_EQ(contact(alone, {3.0, 1.0, 2.0}, 2).time, 2.0);
  EXPECT_EQ(contact(alone, {3.0, 1.0, 2.0}, 2).point, std::size_t{2});
  EXPECT_EQ(contact(alone, {3.0, 1.0, 2.0}, 0).time, 1.0) << "0 counts as 1";
  EXPECT_FALSE(contact(alone, {3.0, infinity, 2.0}, 3).point) << "two are too few";
}

TEST(Contact, PointThatStandsForSeveralReturnsCountsAsThem) {
  EXPECT_EQ(contact(obstacles_of({1, 5, 1}), {1.0, 2.0, 3.0}, 3).time, 2.0);
  EXPECT_EQ(contact(obstacles_of({1, 1, 1}), {1.0, 2.0, 3.0}, 3).time, 3.0);
}

TEST(Contact, WhatIsNeverTouchedHasNoTime) {
  const Contact none = contact(obstacles_of({9}), {infinity}, 1);
  EXPECT_EQ(none.time, infinity);
  EXPECT_FALSE(none.point);
}

TEST(Contact, OfASingleReturnNoMoreAreAskedThanAreNeeded) {
  const Obstacles many{std::vector<Point2>(10), {}, 0.0};
  int asked = 0;
  const auto time_of = [&](const Point2&, double) { return 5.0 - ++asked; };
  EXPECT_EQ(contact(many, 1, 3.5, time_of).time, 3.0);
  EXPECT_EQ(asked, 2);
  asked = 0;
  EXPECT_EQ(contact(many, 2, 3.5, time_of).time, -4.0) << "the second of all";
  EXPECT_EQ(asked, 10);
}

/// Times: how far ahead the points lie.
double ahead(const Point2& point, double) { return point.x; }

TEST(Contact, IsTheFirstOfThoseThatCount) {
  Obstacles obstacles{{{3.0, 0.0}, {1.0, 0.0}, {0.5, 0.0}, {4.0, 0.0}}, {}, 0.0};
  EXPECT_EQ(contact(obstacles, 1, 0.0, ahead).point, 2u);
  int asked = 0;
  obstacles.condition = Condition([&](const Point2& point) { return ++asked, point.x > 0.7; });
  EXPECT_EQ(contact(obstacles, 1, 0.0, ahead).point, 1u);
  EXPECT_EQ(asked, 3) << "not whether what lies behind another counts";
  EXPECT_EQ(contact(obstacles, 2, 0.0, ahead).time, 3.0);
  EXPECT_EQ(contact(obstacles, 3, 0.0, ahead).time, 4.0);
  EXPECT_FALSE(contact(obstacles, 4, 0.0, ahead).point);
}

TEST(Contact, IsNoLaterThanWhatIsKnownAlready) {
  const Obstacles obstacles{{{3.0, 0.0}, {1.0, 0.0}}, {}, 0.0};
  EXPECT_EQ(contact(obstacles, 1, 0.0, ahead, {2.0, 7}).point, 1u);
  EXPECT_EQ(contact(obstacles, 1, 0.0, ahead, {0.5, 7}).point, 7u);
}

}  // namespace
}  // namespace safety_control_cloud
