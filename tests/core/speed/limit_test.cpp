// SPDX-License-Identifier: BSD-3-Clause
// tests/python/path asks it in many scenes, and drives by it.
#include "../../../safety_control_cloud/core/speed/limit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "../../../safety_control_cloud/core/speed/straying.hpp"
#include "../path/footprints.hpp"

namespace safety_control_cloud {
namespace {

Limit limit_before(const Obstacles& obstacles, const Twist2& wanted, const std::vector<Twist2>& under_way = {}) {
  return limit(circle(0.2, 0.05), Law{}, obstacles, {}, {under_way}, wanted);
}

Obstacles wall_at(double x) { return {{{x, 0.0}}, {}, 0.0}; }

TEST(Limit, WithNothingAroundEveryWishPasses) {
  const Limit limit = limit_before({}, {5.0, -3.0, 2.0}, {{-4.0, 0.0, 1.0}});
  EXPECT_EQ(limit.factor, 1.0);
  EXPECT_FALSE(limit.contact.point);
}

TEST(Limit, OfSeveralMotionsUnderWayTheWorstDecides) {
  const double alone = limit_before(wall_at(0.45), {0.3, 0.0, 0.0}, {{0.3, 0.0, 0.0}}).factor;
  EXPECT_GT(alone, 0.0);
  EXPECT_EQ(limit_before(wall_at(0.45), {0.3, 0.0, 0.0}, {{0.3, 0.0, 0.0}, {0.9, 0.0, 0.0}}).factor, 0.0);
  EXPECT_EQ(limit_before(wall_at(0.45), {0.3, 0.0, 0.0}, {{0.3, 0.0, 0.0}, {NAN, 0.0, 0.0}}).factor, 0.0);
}

TEST(Limit, ReducedObstaclesAreWidened) {
  Obstacles obstacles = wall_at(0.45);
  const double exact = limit_before(obstacles, {0.5, 0.0, 0.0}).factor;
  obstacles.widening = 0.05;
  const double widened = limit_before(obstacles, {0.5, 0.0, 0.0}).factor;
  EXPECT_LT(widened, exact);
  EXPECT_DOUBLE_EQ(widened, limit_before(wall_at(0.40), {0.5, 0.0, 0.0}).factor);
}

TEST(Limit, ReducedObstaclesInsideTheMarginAreNoWayOut) {
  Obstacles obstacles = wall_at(0.22);
  EXPECT_TRUE(limit_before(obstacles, {-0.1, 0.0, 0.0}).is_escape);
  obstacles.widening = 0.01;
  EXPECT_EQ(limit_before(obstacles, {-0.1, 0.0, 0.0}).factor, 0.0);
}

TEST(Limit, TheWayOutIsClosedWhileTheRobotStillMovesOtherwise) {
  EXPECT_EQ(limit_before(wall_at(0.22), {-0.1, 0.0, 0.0}, {{0.2, 0.0, 0.0}}).factor, 0.0);
  EXPECT_GT(limit_before(wall_at(0.22), {-0.1, 0.0, 0.0}, {{-0.1, 0.0, 0.0}}).factor, 0.0);
}

/// Told to stop, it would lose its turning first, and leave the arc; slowed along that it stands in time.
/// A wish that is tried in many steps: what is in the way of one is asked first at the next.
TEST(Limit, IsTheSameInWhateverOrderTheObstaclesAre) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> upto(-1.0, 1.0);
  int slowed = 0;
  for (int i = 0; i < 300; ++i) {
    Obstacles obstacles;
    for (int k = 0; k < 40; ++k) obstacles.points.push_back({0.9 + 0.5 * upto(random), upto(random)});
    const Twist2 wanted{0.6 + 0.4 * upto(random), 0.0, 1.5 * upto(random)}, other{0.3, 0.0, upto(random)};
    const std::vector<Twist2> under_way{limited(wanted, 0.3), other};
    const double factor = limit_before(obstacles, wanted, under_way).factor;
    slowed += factor > 0.0 && factor < 1.0;
    for (int k = 0; k < 3; ++k) {
      std::shuffle(obstacles.points.begin(), obstacles.points.end(), random);
      EXPECT_EQ(limit_before(obstacles, wanted, under_way).factor, factor);
    }
    double least = 1.0;
    for (const Point2& point : obstacles.points)
      least = std::min(least, limit_before({{point}, {}, 0.0}, wanted, under_way).factor);
    EXPECT_LE(factor, least);
    const std::size_t half = obstacles.points.size() / 2;
    Obstacles some{{obstacles.points.begin(), obstacles.points.begin() + half}, {}, 0.0};
    std::set<const Point2*> asked;
    obstacles.condition = Condition([&](const Point2& point) {
      EXPECT_TRUE(asked.insert(&point).second) << "once";
      return &point < obstacles.points.data() + half;
    });
    EXPECT_EQ(limit_before(obstacles, wanted, under_way).factor, limit_before(some, wanted, under_way).factor);
  }
  EXPECT_GT(slowed, 30);
}

TEST(Limit, WhoCanBeSlowedAlongHisWayInTimeIsNotToldToStop) {
  const Twist2 wanted{0.44, 0.0, 0.45};
  const auto factor_before = [&](double distance, double slowing) {
    return limit(circle(0.2, 0.05), Law{}, wall_at(distance), {}, {{wanted}, slowing}, wanted).factor;
  };
  double first = infinity, last = 0.0;
  for (double distance = 0.5; distance < 0.9; distance += 0.005) {
    const double alone = factor_before(distance, 0.0), slowed = factor_before(distance, 0.8);
    EXPECT_TRUE(slowed == alone || (alone < 0.8 && slowed == 0.8)) << distance;
    if (slowed != alone) first = std::min(first, distance), last = std::max(last, distance);
  }
  EXPECT_GT(last - first, 0.02) << "the law has it stop before it must";
  EXPECT_GT(first, 0.55) << "too late even so";
}

TEST(Limit, SaysWhatDecided) {
  const Limit limit = limit_before({{{3.0, 0.0}, {0.45, 0.0}, {1.0, 0.0}}, {}, 0.0}, {0.5, 0.0, 0.0});
  EXPECT_EQ(limit.contact.point, 1u);
  EXPECT_DOUBLE_EQ(limit.contact.time, 0.4);
}

TEST(Straying, IsLessForWhoDrivesLess) {
  const Law law;
  const Outline outline = long_robot();
  const Twist2 wanted{0.5, 0.0, 0.5};
  const Response response = response_to(law, {}, wanted);
  double before = infinity;
  for (const double most : {1.0, 0.7, 0.3, 0.1}) {
    const double widening = straying(outline, law, response, {}, wanted, {0.0, most}).widening;
    EXPECT_LT(widening, before);
    before = widening;
  }
  EXPECT_LT(before, 0.01);
}

}  // namespace
}  // namespace safety_control_cloud
