// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/contradiction.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>

#include "robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

/// Ways between which a base went that did as it was told.
std::vector<Pose2> between_ways(const Pose2& a, const Pose2& b) {
  return {a, b, {a.place, b.heading}, {b.place, a.heading}};
}

bool contradicts(const Pose2& way, const std::vector<Pose2>& as_told) {
  return compared(way, as_told).contradiction.has_value();
}

TEST(Contradiction, IsAWayAgainstAllThatTheBaseWasTold) {
  const auto ahead = between_ways({{0.2, 0.0}, -0.05}, {{0.5, 0.0}, 0.05});
  EXPECT_TRUE(contradicts({{-0.3, 0.0}, 0.0}, ahead));
  for (const double x : {-0.02, 0.0, 0.1, 0.3, 0.9}) EXPECT_FALSE(contradicts({{x, 0.0}, 0.0}, ahead)) << x;
  EXPECT_FALSE(contradicts({{-0.3, 0.0}, 0.0}, between_ways({{-0.1, 0.0}, 0.0}, {{0.5, 0.0}, 0.0}))) << "perhaps";
  EXPECT_FALSE(contradicts({{-0.3, 0.0}, 0.0}, between_ways({{0.05, 0.0}, 0.0}, {{0.5, 0.0}, 0.0}))) << "hardly told";
  EXPECT_FALSE(contradicts({{-0.3, 0.0}, 1.3}, between_ways({{0.2, 0.0}, 1.0}, {{0.5, 0.0}, 2.0}))) << "turns far";
  EXPECT_FALSE(contradicts({{-0.3, 0.0}, 0.0}, {})) << "nothing told";
  EXPECT_TRUE(compared({{0.3, 0.0}, 0.0}, ahead).agrees);
  for (const double x : {-0.3, 0.0, 0.02}) EXPECT_FALSE(compared({{x, 0.0}, 0.0}, ahead).agrees) << x;
  EXPECT_FALSE(compared({{0.3, 0.0}, 0.0}, {}).agrees);
  const auto backward = between_ways({{-0.2, 0.0}, 0.0}, {{-0.5, 0.0}, 0.0});
  EXPECT_TRUE(contradicts({{0.3, 0.0}, 0.0}, backward));
  EXPECT_FALSE(contradicts({{-0.3, 0.0}, 0.0}, backward));
  const auto left = between_ways({{0.0, 0.2}, 0.0}, {{0.0, 0.5}, 0.0});
  EXPECT_TRUE(contradicts({{0.0, -0.3}, 0.0}, left));
  EXPECT_FALSE(contradicts({{0.0, 0.3}, 0.0}, left));
}

TEST(Contradiction, IsATurnAgainst) {
  const auto turning = between_ways({{0.2, 0.0}, 0.4}, {{0.5, 0.1}, 0.8});
  EXPECT_TRUE(contradicts({{0.3, 0.0}, -0.5}, turning));
  EXPECT_FALSE(contradicts({{0.3, 0.0}, 0.1}, turning));
  EXPECT_FALSE(contradicts({{0.3, 0.0}, 0.0}, turning)) << "some do not turn so slowly";
  EXPECT_FALSE(contradicts({{0.0, 0.0}, 0.0}, turning)) << "it rests: somebody may have pressed its stop button";
  EXPECT_FALSE(contradicts({{0.3, 0.0}, -0.5}, between_ways({{0.2, 0.0}, 0.1}, {{0.5, 0.1}, 0.8}))) << "hardly told";
}

TEST(Contradiction, StoodIsWhoDidNeitherThoughTheBaseWasToldTo) {
  const auto ahead = between_ways({{0.2, 0.0}, -0.05}, {{0.5, 0.0}, 0.05});
  const auto turning = between_ways({{0.0, 0.0}, 0.4}, {{0.0, 0.0}, 0.8});
  EXPECT_TRUE(compared({}, ahead).stood);
  EXPECT_TRUE(compared({}, turning).stood);
  EXPECT_FALSE(compared({{0.03, 0.0}, 0.0}, ahead).stood);
  EXPECT_FALSE(compared({{0.0, 0.0}, 0.03}, turning).stood);
  EXPECT_FALSE(compared({}, between_ways({}, {{0.5, 0.0}, 0.0})).stood) << "perhaps it was to stand";
  EXPECT_FALSE(compared({}, {}).stood);
}

TEST(Contradiction, HasStoodUntilItAgreesAgain) {
  const Compared stood{false, {}, true}, along{true, {}}, neither;
  Contradictions all;
  double now = 100.0;
  const auto has_stood_after = [&](const Compared& one, double seconds) {
    for (double t = 0.0; t < seconds; t += 0.05) all.note(one, now += 0.05);
    return all.has_stood();
  };
  EXPECT_FALSE(has_stood_after(along, 2.0));
  EXPECT_FALSE(has_stood_after(stood, 0.2));
  EXPECT_TRUE(has_stood_after(stood, 0.2));
  EXPECT_TRUE(has_stood_after(neither, 20.0));
  EXPECT_FALSE(has_stood_after(along, 0.05));
}

TEST(Contradiction, PrevailsWhereItIsMostOfWhatCanBeCompared) {
  const Compared against{false, "backward"}, along{true, {}}, neither;
  const auto after = [&](std::initializer_list<std::pair<Compared, double>> each) {
    Contradictions all;
    double now = 100.0;
    for (const auto& [one, seconds] : each)
      for (double t = 0.0; t < seconds; t += 0.05) all.note(one, now += 0.05);
    return all.prevail();
  };
  EXPECT_FALSE(after({{neither, 5.0}}));
  EXPECT_FALSE(after({{against, 0.2}}));
  EXPECT_TRUE(after({{against, 0.5}}));
  EXPECT_FALSE(after({{along, 2.0}, {against, 1.4}})) << "pushed";
  EXPECT_TRUE(after({{along, 2.0}, {against, 4.0}}));
  EXPECT_TRUE(after({{along, 5.0}, {neither, 60.0}, {against, 0.5}})) << "long ago";
}

}  // namespace
}  // namespace safety_control_cloud
