// SPDX-License-Identifier: BSD-3-Clause
// Where the robot went: by odometry, or by what it was told.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "../../../safety_control_cloud/core/guard/command.hpp"
#include "../../../safety_control_cloud/core/guard/given.hpp"
#include "../../../safety_control_cloud/core/guard/odometry.hpp"

namespace safety_control_cloud {
namespace {

constexpr Following slow{0.15, 0.36, 3.5};

/// Says for `seconds` from `from` on where a robot is that keeps a twist from the origin on.
void drive(Odometry& odometry, const Twist2& twist, double from, double seconds) {
  for (int i = 0; i <= std::lround(seconds / 0.02); ++i) odometry.note(from + 0.02 * i, way_of(twist, 0.02 * i), twist);
}

void expect_near(const std::optional<Pose2>& way, const Pose2& expected, double tolerance) {
  ASSERT_TRUE(way);
  EXPECT_NEAR(way->place.x, expected.place.x, tolerance);
  EXPECT_NEAR(way->place.y, expected.place.y, tolerance);
  EXPECT_NEAR(way->heading, expected.heading, 1e-9);
}

TEST(Pose, AWayIsSeenBackwardByARestingPoint) {
  const Twist2 twist{0.3, 0.1, 0.7};
  const Point2 point{1.0, -0.5};
  const Point2 carried = SeenAfter(way_of(twist, 0.8))(point), direct = moved(point, twist, 0.8);
  EXPECT_NEAR(carried.x, direct.x, 1e-12);
  EXPECT_NEAR(carried.y, direct.y, 1e-12);
}

TEST(Odometry, TellsTheWayBetweenAndBeyondItsPoses) {
  Odometry odometry;
  const Twist2 twist{0.4, 0.0, 0.5};
  drive(odometry, twist, 10.0, 1.0);
  expect_near(odometry.way_since(10.33, 11.1), way_of(twist, 0.77), 1e-4);
}

/// As TF has it: of the pose alone.
TEST(Odometry, OfPosesAloneTellsTheSameWayAndTheTwistBetweenThem) {
  Odometry odometry;
  const Twist2 twist{0.4, 0.1, -2.0};
  for (int i = 0; i <= 100; ++i) {  // through half a turn, where headings are wrapped
    Pose2 pose = way_of(twist, 0.02 * i);
    pose.heading = std::remainder(pose.heading, 2.0 * std::acos(-1.0));
    odometry.note_pose(10.0 + 0.02 * i, pose, 0.7, 3.14);
  }
  EXPECT_EQ(odometry.breaks(), std::size_t{0});
  expect_near(odometry.way_since(10.33, 12.0), way_of(twist, 1.67), 1e-3);
  ASSERT_TRUE(odometry.twist_at(12.0));
  EXPECT_NEAR(odometry.twist_at(12.0)->vx, twist.vx, 0.01);
  EXPECT_NEAR(odometry.twist_at(12.0)->vy, twist.vy, 0.01);
  EXPECT_NEAR(odometry.twist_at(12.0)->w, twist.w, 1e-9);
}

TEST(Odometry, OfPosesAloneWhatIsFasterThanTheRobotIsAJump) {
  for (const Pose2& odd : {Pose2{{0.5, 0.0}, 0.0}, Pose2{{0.0, -3.0}, 0.0}, Pose2{{0.0, 0.0}, 0.5},
                           Pose2{{std::nan(""), 0.0}, 0.0}, Pose2{{0.0, 0.0}, std::nan("")}}) {
    Odometry odometry;
    for (int i = 0; i < 10; ++i) odometry.note_pose(10.0 + 0.02 * i, {}, 0.7, 3.14);
    odometry.note_pose(10.2, odd, 0.7, 3.14);
    EXPECT_EQ(odometry.breaks(), std::size_t{1}) << odd.place.x << ' ' << odd.heading;
    EXPECT_FALSE(odometry.way_since(10.1, 10.2));
  }
  Odometry back;
  back.note_pose(10.0, {}, 0.7, 3.14);
  back.note_pose(9.0, {}, 0.7, 3.14);
  EXPECT_EQ(back.breaks(), std::size_t{1});
}

TEST(Odometry, DoesNotSpanWhatItHasNotSeen) {
  Odometry odometry;
  EXPECT_FALSE(odometry.way_since(0.0, 0.1));
  drive(odometry, {0.4, 0.0, 0.0}, 10.0, 1.0);
  EXPECT_FALSE(odometry.way_since(9.9, 11.0)) << "before it began";
  EXPECT_FALSE(odometry.way_since(10.5, 11.5)) << "it has ceased";
  EXPECT_FALSE(odometry.twist_at(11.5));
}

TEST(Odometry, AJumpAGapOrNoNumberBeginsItAnew) {
  const Twist2 twist{0.4, 0.0, 0.0};
  for (const Pose2& odd : {Pose2{{5.0, 0.0}, 0.0}, Pose2{{0.4, 0.0}, 1.5}, Pose2{{std::nan(""), 0.0}, 0.0}}) {
    Odometry odometry;
    drive(odometry, twist, 10.0, 1.0);
    odometry.note(11.02, odd, twist);
    EXPECT_FALSE(odometry.way_since(10.5, 11.02));
  }
  Odometry late, back;
  drive(late, twist, 10.0, 1.0);
  late.note(11.4, {{0.56, 0.0}, 0.0}, twist);
  EXPECT_FALSE(late.way_since(10.5, 11.4));
  drive(back, twist, 10.0, 1.0);
  back.note(10.5, {{0.2, 0.0}, 0.0}, twist);
  EXPECT_FALSE(back.way_since(10.4, 10.5));
}

TEST(Odometry, AHalfTurnIsNoJump) {
  Odometry odometry;
  for (int i = 0; i < 20; ++i) {
    const double heading = 3.0 + 0.02 * i;
    odometry.note(1.0 + 0.02 * i, {{0.0, 0.0}, std::remainder(heading, 2 * 3.14159265358979323846)}, {0.0, 0.0, 1.0});
  }
  const auto way = odometry.way_since(1.0, 1.38);
  ASSERT_TRUE(way);
  EXPECT_NEAR(way->heading, 0.38, 1e-9);
}

TEST(Given, ABaseThatWasToldNothingStands) {
  const Given given(slow);
  ASSERT_EQ(given.under_way(1.0).size(), 1u);
  EXPECT_TRUE(stands(given.under_way(1.0)[0]));
  EXPECT_EQ(given.ways_since(given.reckoned_at(0.0), 1.0).size(), 1u);
}

TEST(Given, WhatIsUnderWayBrakesNoFasterThanItCan) {
  Given given(slow);
  for (int i = 0; i <= 50; ++i) given.note({0.5, 0.0, 0.0}, 1.0 + 0.02 * i);
  for (int i = 1; i <= 20; ++i) given.note({}, 2.0 + 0.02 * i);
  double fastest = 0.0;
  for (const Twist2& twist : given.under_way(2.4)) fastest = std::max(fastest, twist.vx);
  const double now = 0.5 - 0.36 * (0.4 - 0.02 - 0.15);
  EXPECT_LE(fastest, now);
  EXPECT_NEAR(fastest * 0.15 + fastest * fastest / 0.72, now * now / 0.72, 2e-3) << "as if steady, then the same way";
  const std::vector<Twist2> later = given.under_way(4.5);
  EXPECT_TRUE(stands(later[0]));
}

TEST(Given, ABaseThatIsToldToTurnRoundMayStillGoOn) {
  Given given(slow);
  for (int i = 0; i <= 50; ++i) given.note({0.5, 0.0, 0.0}, 1.0 + 0.02 * i);
  for (int i = 1; i <= 15; ++i) given.note({-0.6, 0.0, 0.0}, 2.0 + 0.02 * i);
  double fastest = -1.0;
  for (const Twist2& twist : given.under_way(2.3)) fastest = std::max(fastest, twist.vx);
  EXPECT_GT(fastest, 0.4);
}

/// [m] until the robot stands, in the form of speed/law.hpp, of the worst of what may be under way.
double longest_stop(const std::vector<Twist2>& under_way) {
  double longest = 0.0;
  for (const Twist2& twist : under_way)
    longest =
        std::max(longest, std::abs(twist.vx) * slow.delay + twist.vx * twist.vx / (2.0 * slow.linear_deceleration));
  return longest;
}

/// The same of a base that obeys after `delay` [s] and brakes as slowly as it may, told to stand now.
double true_stop(const std::vector<Twist2>& told, double period, double delay) {
  double speed = told.front().vx, way = 0.0, aim = speed;
  const double now = period * static_cast<double>(told.size() - 1);
  for (double time = 0.0; time < now + 5.0; time += 1e-3) {
    const double since = time - delay;
    if (since >= now)
      aim = 0.0;
    else if (since >= 0.0)
      aim = told[static_cast<std::size_t>(since / period)].vx;
    speed = aim > speed ? aim : std::max(aim, speed - 1e-3 * slow.linear_deceleration);
    if (time >= now) way += 1e-3 * speed;
  }
  return way;
}

TEST(Given, NoStoppingWayIsLongerThanOfWhatIsUnderWay) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int turn = 0; turn < 300; ++turn) {
    Given given(slow);
    std::vector<Twist2> told;
    double speed = share(random);
    const double falls = 0.1 * share(random), jumps = turn % 3 == 0 ? 0.3 : 0.0, unsteady = turn % 2 == 0 ? 0.1 : 0.0;
    for (int i = 0; i < 40; ++i) {
      speed = share(random) < jumps ? share(random) : std::max(0.0, speed - falls * share(random));
      told.push_back({0.7 * speed, 0.3 * unsteady * (share(random) - 0.5), unsteady * (share(random) - 0.5)});
      given.note(told.back(), 1.0 + 0.05 * i);
    }
    const double longest = longest_stop(given.under_way(1.0 + 0.05 * 39));
    for (const double delay : {0.0, 0.04, 0.08, 0.12, 0.15})
      EXPECT_LE(true_stop(told, 0.05, delay), longest + 2e-3) << "turn " << turn << ", delay " << delay;
  }
}

TEST(Given, WhatWasTakenBackLastsNoLongerThanUntilThatHasItsEffect) {
  Given given(slow);
  for (int i = 0; i <= 50; ++i) given.note({0.5, 0.0, 0.0}, 1.0 + 0.02 * i);
  given.note({0.4, 0.0, 0.0}, 2.01);
  const double lasts = 2.01 + slow.delay - 2.14;  // then it may go at 0.5 still
  const double braked = (0.5 * 0.5 - 0.4 * 0.4) / (2 * slow.linear_deceleration);
  const double least = lasts * 0.5 + braked;
  EXPECT_GT(longest_stop(given.under_way(2.14)), least);
  EXPECT_LT(longest_stop(given.under_way(2.14)), 0.5 * slow.delay + 0.5 * 0.5 / (2 * slow.linear_deceleration) - 0.02);
  EXPECT_LT(longest_stop(given.under_way(2.14, Twist2{0.5, 0.0, 0.0})), 0.5 * slow.delay + 0.34) << "measured or not";
  EXPECT_GT(longest_stop(given.under_way(2.14, Twist2{0.7, 0.0, 0.0})), 0.7 * lasts + 0.7 * 0.7 / 0.72)
      << "nobody told it that";
}

TEST(Given, TheTrueWayLiesBetweenTheOnesThatItNames) {
  Given given(slow);
  for (int i = 0; i <= 10; ++i) given.note({0.5, 0.0, 0.0}, 1.0 + 0.02 * i);
  double farthest = 0.0;
  for (const Pose2& way : given.ways_since(given.reckoned_at(1.0), 1.2)) farthest = std::max(farthest, way.place.x);
  EXPECT_NEAR(farthest, 0.1, 1e-6) << "who obeys at once";
}

TEST(Given, AWayIsNotForgottenHoweverLongAgoItWasGone) {
  Given given(slow);
  const auto then = given.reckoned_at(0.9);
  for (int i = 0; i <= 50; ++i) given.note({0.5, 0.0, 0.2}, 1.0 + 0.02 * i);
  for (int i = 1; i <= 1500; ++i) given.note({}, 2.0 + 0.02 * i);
  const auto ways = given.ways_since(then, 32.0);
  ASSERT_EQ(ways.size(), 4u);
  const Pose2 at_once = way_of({0.5, 0.0, 0.2}, 1.02);
  EXPECT_NEAR(ways[1].place.x, at_once.place.x, 1e-6);
  EXPECT_NEAR(ways[1].heading, at_once.heading, 1e-6);
  EXPECT_NEAR(ways[2].heading, 0.5 * at_once.heading, 1e-6);
  EXPECT_GT(ways[3].place.x, at_once.place.x + 0.25) << "it braked late and slowly";
}

TEST(Given, WhatWasSeenTenSecondsAgoHasAWholeWayBehindIt) {
  Given given(slow);
  for (int i = 0; i <= 600; ++i) given.note({0.5, 0.0, 0.0}, 1.0 + 0.02 * i);
  EXPECT_NEAR(given.ways_since(given.reckoned_at(3.0), 13.0)[1].place.x, 5.0, 1e-6);
}

/// Of any base that is as quick to gain speed as to lose it.
TEST(Given, WhereaboutsSpanWhereSuchABaseIs) {
  for (const double delay : {0.01, 0.08, 0.15}) {
    for (const double quickness : {1.0, 3.0, 30.0}) {
      Given given(slow);
      double x = 0.0, speed = 0.0, gone = 0.0;
      const auto told_at = [](double time) { return time < 0.0 ? 0.0 : time < 2.0 ? 0.5 : time < 3.0 ? -0.2 : 0.0; };
      for (int i = 0; i <= 1000; ++i) {
        const double time = 0.005 * i, most = 0.005 * quickness * slow.linear_deceleration;
        if (i % 4 == 0) given.note({told_at(time), 0.0, 0.0}, 1.0 + time);
        speed += std::clamp(told_at(time - delay) - speed, -most, most);
        x += 0.005 * speed, gone += 0.005 * std::abs(speed);
        const Whereabouts there = given.whereabouts_at(1.0 + time + 0.005);
        double off = 0.01;
        for (const Pose2& other : there.or_else) off = std::max(off, std::abs(other.place.x - there.pose.place.x));
        EXPECT_LT(off, 0.8);
        EXPECT_NEAR(x, there.pose.place.x, off + there.drift * gone) << "at " << time << " s, delay " << delay;
      }
    }
  }
}

/// A process that was stopped says nothing, and who hears nothing may stand or go on.
TEST(Given, WhoIsToldNothingMayHaveStoodSince) {
  Given given(slow);
  for (int i = 0; i <= 50; ++i) given.note({0.2, 0.0, 0.0}, 1.0 + 0.02 * i);
  const Whereabouts there = given.whereabouts_at(7.0);
  double least = 9.0, most = 0.0;
  for (const Pose2& one : there.or_else) least = std::min(least, one.place.x), most = std::max(most, one.place.x);
  EXPECT_NEAR(least, 0.3, 0.02);
  EXPECT_NEAR(most, 1.2, 1e-6);
}

TEST(Command, IsScaledAsAWhole) {
  Command command;
  command.linear = {0.4, -0.2, 0.0};
  command.angular = {0.0, 0.0, 1.0};
  EXPECT_EQ(scaled(command, 0.5).linear[1], -0.1);
  EXPECT_EQ(scaled(command, 0.5).angular[2], 0.5);
  EXPECT_TRUE(stands(in_plane(scaled(command, std::nan("")))));
}

}  // namespace
}  // namespace safety_control_cloud
