// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/looks_taken.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

constexpr std::size_t front = 0, rear = 1;

Whereabouts at(double x, double heading = 0.0) { return {{{x, 0.0}, heading}, {}, 0.1}; }

TEST(LooksTaken, EachIsFoundByItsNumberUntilItIsForgotten) {
  LooksTaken looks;
  EXPECT_EQ(looks.find(looks.latest()), nullptr);
  looks.take_placed(front, at(1.0), 10.0);
  looks.take(rear, 10.1);
  looks.take_placed(front, at(2.0), 10.2);
  ASSERT_NE(looks.find(1), nullptr);
  EXPECT_EQ(looks.find(1)->at, 10.0);
  EXPECT_EQ(looks.find(2)->sensor, rear);
  EXPECT_FALSE(looks.is_latest_of_its_sensor(1));
  EXPECT_TRUE(looks.is_latest_of_its_sensor(2));
  looks.forget_before(10.15);
  EXPECT_EQ(looks.find(2), nullptr);
  EXPECT_FALSE(looks.is_latest_of_its_sensor(2));
  EXPECT_EQ(looks.find(3)->robot.pose.place.x, 2.0);
  EXPECT_EQ(looks.find(4), nullptr) << "not taken yet";
}

TEST(LooksTaken, EachTellsByHowMuchTheWaySinceTheOneBeforeMayBeOff) {
  LooksTaken looks;
  EXPECT_EQ(looks.take_placed(front, at(0.0), 10.0, 70.0).at(2.0), 0.0);
  EXPECT_NEAR(looks.take_placed(front, at(3.0, 0.5), 11.0, 71.0).at(2.0), 0.1 * 3.0 + 0.1 * 0.5 * 2.0, 1e-12);
  EXPECT_NEAR(looks.drift_from_latest_to(at(4.0, 0.5)).at(2.0), 0.1 * 1.0, 1e-12);
}

/// Two cameras of which one is later than the other would count each step of the way again and again.
TEST(LooksTaken, OneOfAnEarlierStampGoesNoWay) {
  LooksTaken looks;
  looks.take_placed(front, at(3.0), 11.0, 71.0);
  EXPECT_EQ(looks.take_placed(rear, at(2.0), 11.1, 70.5).at(1.0), 0.0);
  EXPECT_NEAR(looks.drift_from_latest_to(at(2.0)).at(1.0), 0.1 * 1.0, 1e-12) << "for what that one shows";
  EXPECT_NEAR(looks.take_placed(front, at(3.5), 11.2, 71.2).at(1.0), 0.1 * 0.5, 1e-12);
}

TEST(LooksTaken, TheLatestMayHaveBeenTakenBeforeOthers) {
  LooksTaken looks;
  looks.take_placed(front, at(0.0), 10.0, 70.0, 0.02);
  looks.take_placed(rear, at(0.0), 10.1, 69.8, 0.3);
  EXPECT_TRUE(looks.is_latest_older_than(1));
  EXPECT_FALSE(looks.is_latest_older_than(2)) << "itself";
  looks.go_on_in_frame(at(1.0));
  EXPECT_TRUE(looks.is_latest_older_than(1)) << "in whichever frame";
  looks.take_placed(rear, at(0.0), 10.4, 70.1, 0.3);
  EXPECT_FALSE(looks.is_latest_older_than(1));
  EXPECT_FALSE(looks.is_latest_older_than(5)) << "not taken yet";
}

TEST(WaySince, NamesWhereTheRobotMayBeInstead) {
  LooksTaken looks;
  looks.take_placed(front, {{{0.0, 0.0}, 0.0}, {{{0.0, 0.0}, 0.0}, {{-0.2, 0.0}, 0.0}}}, 10.0);
  const Whereabouts now{{{1.0, 0.0}, 0.0}, {{{1.0, 0.0}, 0.0}, {{0.5, 0.0}, 0.1}}};
  WaySince way(looks, now);
  ASSERT_EQ(way.or_else(1).size(), 2u);
  EXPECT_NEAR(way.or_else(1)[1].place.x, 0.7 - 1.0, 1e-12);
  EXPECT_NEAR(way.beside(1, 2.0), 0.3 + 0.1 * 2.0, 1e-12);
  EXPECT_TRUE(way.or_else(2).empty()) << "not taken yet";
}

TEST(LooksTaken, InAnotherFrameTheWayBeginsAnew) {
  LooksTaken looks;
  looks.take_placed(front, {{{0.0, 0.0}, 0.0}, {{{-0.2, 0.0}, 0.0}}, 0.1}, 10.0);
  looks.take_placed(front, {{{1.0, 0.0}, 0.0}, {{{0.5, 0.0}, 0.0}}, 0.1}, 11.0, 71.0);
  EXPECT_EQ(looks.find(2)->stamp, 71.0);
  looks.go_on_in_frame({{{30.0, 0.0}, 0.0}});
  EXPECT_FALSE(looks.find(2)->stamp) << "where the robot was then, in the new frame, nobody has told";
  EXPECT_NEAR(looks.drift_from_latest_to(at(31.0)).at(1.0), 0.1, 1e-12);
  const Whereabouts now = at(31.0);
  WaySince way(looks, now);
  for (const std::uint64_t look : {1, 2}) EXPECT_EQ(way.beside(look, 1.0), 0.0) << look;
}

}  // namespace
}  // namespace safety_control_cloud
