// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/given.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "../../../safety_control_cloud/core/guard/command.hpp"

namespace safety_control_cloud {
namespace {

constexpr Following slow{0.15, 0.36, 3.5};

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

/// A base that obeys after `delay` [s], gains speed at once or slowly, and loses it at some rate that it may.
struct Base {
  double delay, gains, loses;  ///< [s], and times the slowest
  Twist2 twist = {};
  Pose2 pose = {};

  void go_on(const Twist2& aim, double time) {
    const auto next = [&](double from, double to, double slowest) {
      const bool is_gaining = from * to >= 0.0 && std::abs(to) > std::abs(from);
      const double most = (is_gaining ? gains : loses) * slowest * time;
      return from + std::clamp(to - from, -most, most);
    };
    twist = {next(twist.vx, aim.vx, slow.linear_deceleration), 0.0, next(twist.w, aim.w, slow.angular_deceleration)};
    pose = beyond(pose, way_of(twist, time));
  }
};

/// Since any moment, not only in all: what was seen then counts from where the robot was.
TEST(Given, WhereaboutsSpanTheWayOfABaseThatCoastsBetweenBursts) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  constexpr double step = 0.005, every = 0.05;
  for (int turn = 0; turn < 200; ++turn) {
    Given given(slow);
    Base base{slow.delay * share(random), turn % 2 == 0 ? 1e4 : 1.0, turn % 3 == 0 ? 20.0 : 1.0};
    const double speed = 0.7 * share(random), turning = 0.5 * (share(random) - 0.5), often = share(random);
    std::vector<Twist2> told;
    std::vector<Pose2> poses;
    std::vector<Whereabouts> there;
    for (int i = 0; i * step < 4.0; ++i) {
      if (i % 10 == 0) {
        told.push_back(limited({speed, 0.0, turning}, i > 0 && share(random) < often ? 1.0 : 0.0));
        given.note(told.back(), 1.0 + i * step);
        poses.push_back(base.pose);
        there.push_back(given.whereabouts_at(1.0 + i * step));
      }
      const double heard = i * step - base.delay;
      base.go_on(heard < 0.0 ? Twist2{} : told[static_cast<std::size_t>(heard / every)], step);
    }
    for (std::size_t then = 0; then < told.size(); then += 7) {
      const Pose2 way = between(poses[then], poses.back()), taken = between(there[then].pose, there.back().pose);
      double off = 0.0;
      for (std::size_t i = 0; i < there[then].or_else.size(); ++i) {
        const Pose2 other = between(there[then].or_else[i], there.back().or_else[i]);
        off = std::max(off, displacement(between(taken, other), 1.0));
      }
      EXPECT_LE(displacement(between(taken, way), 1.0), off + 0.01)
          << "turn " << turn << ", since " << then << ", lag " << base.delay;
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
  EXPECT_GT(least, 0.15);
  EXPECT_LT(least, 0.3) << "what it was told before, and half a second more";
  EXPECT_NEAR(most, 1.2, 1e-6);
}

}  // namespace
}  // namespace safety_control_cloud
