// SPDX-License-Identifier: BSD-3-Clause
// Who is slowed along his way in place of told to stop.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <optional>

#include "../../../safety_control_cloud/core/guard/command.hpp"
#include "../../../safety_control_cloud/core/guard/given.hpp"

namespace safety_control_cloud {
namespace {

constexpr Following slow{0.15, 0.36, 3.5};

/// A base that obeys so much later, and loses its speed as slowly as it may or so many times as quickly.
struct Base {
  double quickness;
  Twist2 twist;
  std::deque<Twist2> on_its_way = std::deque<Twist2>(15, Twist2{});  ///< [10 ms]

  void passes(const Twist2& told) {
    on_its_way.push_back(told);
    const Twist2 aim = on_its_way.front();
    on_its_way.pop_front();
    const auto next = [&](double from, double to, double most) { return from + std::clamp(to - from, -most, 1.0); };
    twist.vx = next(twist.vx, aim.vx, 0.01 * quickness * slow.linear_deceleration);
    twist.w = next(twist.w, aim.w, 0.01 * quickness * slow.angular_deceleration);
  }
};

TEST(Slowing, WhoIsSlowedAlongHisWayIsNowhereFasterThanTheSlowestWhoIsToldToStop) {
  for (const Twist2& wish : {Twist2{0.5, 0.0, 0.4}, Twist2{0.7, 0.0, 0.0}, Twist2{0.1, 0.0, 2.0}}) {
    const bool by_turning = wish.vx < 0.2;  // that takes longer to brake
    Given given(slow);
    Base stopped{1.0, {}}, slowed{1.0, {}}, quick{5.0, {}};
    Twist2 told = wish;
    for (int i = 0; i < 450; ++i) {
      const double now = 1.0 + 0.01 * i;
      if (i >= 200 && i % 5 == 0) told = limited(wish, given.slowing_along(wish, now, 0.1, slowed.twist));
      given.note(told, now);
      stopped.passes(i < 200 ? wish : Twist2{});
      for (Base* base : {&slowed, &quick}) base->passes(told);
      if (i < 200) continue;
      for (const Base* base : {&slowed, &quick}) {
        const double of = by_turning ? base->twist.w : base->twist.vx;
        ASSERT_LE(of, (by_turning ? stopped.twist.w : stopped.twist.vx) + 1e-9) << i;
        ASSERT_NEAR(base->twist.w * wish.vx, base->twist.vx * wish.w, 0.05) << i << ": it keeps to the arc";
      }
    }
    EXPECT_TRUE(stands(slowed.twist));
  }
}

/// One that brakes in proportion to what it is told to brake by.
TEST(Slowing, ABaseThatLagsBehindIsToldToStop) {
  for (const Twist2& wish : {Twist2{0.4, 0.0, 0.2}, Twist2{0.1, 0.0, 2.0}}) {
    Given given(slow);
    for (int i = 0; i < 50; ++i) given.note(wish, 1.0 + 0.02 * i);
    for (int i = 0; i < 25; ++i) given.note(limited(wish, 1.0 - 0.02 * i), 2.0 + 0.02 * i);
    EXPECT_GT(given.slowing_along(wish, 2.5, 0.1, limited(wish, 0.5)), 0.0);
    EXPECT_EQ(given.slowing_along(wish, 2.5, 0.1, wish), 0.0);
    EXPECT_EQ(given.slowing_along(wish, 2.5, 0.1, std::nullopt), 0.0) << "nobody knows";
    EXPECT_EQ(given.slowing_along(wish, 2.5, 0.1, Twist2{}), 0.0) << "nobody measures";
  }
}

TEST(Slowing, WhoIsNotOnTheWayIsNotSlowedAlongIt) {
  Given given(slow);
  EXPECT_EQ(given.slowing_along({0.5, 0.0, 0.0}, 1.0, 0.1, Twist2{}), 0.0) << "it stands";
  for (int i = 0; i < 50; ++i) given.note({0.5, 0.0, 0.0}, 1.0 + 0.02 * i);
  EXPECT_GT(given.slowing_along({0.5, 0.0, 0.1}, 2.0, 0.1, Twist2{0.5, 0.0, 0.0}), 0.8) << "a hand that is not steady";
  for (const Twist2& other : {Twist2{0.5, 0.0, 0.8}, Twist2{-0.5, 0.0, 0.0}, Twist2{0.1, 0.0, 0.0}, Twist2{}})
    EXPECT_EQ(given.slowing_along(other, 2.0, 0.1, Twist2{0.5, 0.0, 0.0}), 0.0) << other.vx << " " << other.w;
}

}  // namespace
}  // namespace safety_control_cloud
