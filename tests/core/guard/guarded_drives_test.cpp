// SPDX-License-Identifier: BSD-3-Clause
// What the guard lets a robot do that drives at a wall, or where nobody looks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <random>
#include <string>

#include "../../../safety_control_cloud/core/guard/directions.hpp"
#include "guarded_robot.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::uint8_t backward = directions[1].bit;

/// A robot that obeys at once, a camera behind it that shows where it is.
TEST(GuardedDrives, WhoDrivesAtAWallStopsBeforeIt) {
  for (const double speed : {0.1, 0.3, 0.7}) {
    GuardedRobot robot;
    double front = 0.8;
    for (int i = 0; i < 300 + 100.0 / speed; ++i) {
      if (i % 5 == 0) robot.see(Scene({wall_before(front)}));
      front -= 0.01 * robot.wants({speed, 0.0, 0.0}).given.linear[0];
      robot.pass(0.01);
      ASSERT_GT(front, 0.04) << speed;
    }
    EXPECT_LT(front, 0.25) << speed << ": it came near";
  }
}

/// Told before is not told now: what it is given may fall, but not to nothing and up again.
void drives_at_a_wall_without_a_halt(double unsteady) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> hand(-unsteady, unsteady);
  for (const double speed : {0.3, 0.45, 0.7}) {
    for (const bool odometry : {false, true}) {
      GuardedRobot robot;
      double front = 1.6, driven = 0.0, least = 1.0;
      std::deque<double> on_its_way(8, 0.0);
      for (int i = 0; front > 0.2 && i < 1000; ++i) {
        if (odometry) robot.control.note_odometry(robot.now.ros, {{1.6 - front, 0.0}, 0.0}, {driven, 0.0, 0.0});
        if (i % 5 == 0) robot.see(Scene({wall_before(front)}));
        on_its_way.push_back(robot.wants({speed + hand(random), 0.0, hand(random)}).given.linear[0]);
        driven += std::clamp(on_its_way.front() - driven, -0.0036, 0.01);
        on_its_way.pop_front();
        if (i > 20 && front > 0.25) least = std::min(least, on_its_way.back());
        front -= 0.01 * driven;
        robot.pass(0.01);
      }
      EXPECT_LE(front, 0.2) << speed;
      EXPECT_GT(least, 0.05) << speed << (odometry ? " with odometry" : "");
    }
  }
}

TEST(GuardedDrives, WhoDrivesAtAWallSlowsDownWithoutAHalt) { drives_at_a_wall_without_a_halt(0.0); }
TEST(GuardedDrives, SoDoesWhoseHandIsNotSteady) { drives_at_a_wall_without_a_halt(0.02); }

/// A base that obeys late, and loses its speed slowly and its turning quickly.
struct LateBase {
  Twist2 twist;
  Pose2 pose;
  std::deque<Twist2> on_its_way = std::deque<Twist2>(8, Twist2{});

  void is_told(const Command& command, double time) {
    on_its_way.push_back({command.linear[0], 0.0, command.angular[2]});
    const Twist2 aim = on_its_way.front();
    on_its_way.pop_front();
    twist.vx += std::clamp(aim.vx - twist.vx, -0.36 * time, time);
    twist.w += std::clamp(aim.w - twist.w, -3.5 * time, 3.5 * time);
    pose = beyond(pose, way_of(twist, time));
  }
};

/// Who loses his turning before his speed leaves the path on which he was judged.
TEST(GuardedDrives, OnAnArcAtSomethingItSlowsDownWithoutLeavingTheArc) {
  for (const Twist2& wish : {Twist2{0.44, 0.0, 0.45}, Twist2{0.3, 0.0, -0.2}, Twist2{0.6, 0.0, 0.3}}) {
    for (const bool odometry : {false, true}) {
      GuardedRobot robot;
      LateBase base;
      const Point2 obstacle = way_of(wish, 1.3 / wish.vx).place;
      Guarded answer;
      double gap = 1.0, least = 1.0, off = 0.0;
      for (int i = 0; gap > 0.12 && i < 1500; ++i) {
        const Point2 there = SeenAfter(base.pose)(obstacle);
        gap = length_of(there) - 0.178;
        if (odometry) robot.control.note_odometry(robot.now.ros, base.pose, base.twist);
        if (i % 5 == 0)
          robot.see(Scene({post(static_cast<float>(there.x + 0.087), static_cast<float>(-there.y - 0.0125), 0.1f)}));
        if (i % 5 == 0) answer = robot.control.answer(robot.now);
        if (i % 5 == 2) answer = robot.wants(wish);
        base.is_told(answer.given, 0.01);
        if (i > 60 && gap > 0.2) {
          least = std::min(least, answer.factor);
          off = std::max(off, std::abs(base.twist.w / wish.w - base.twist.vx / wish.vx));
        }
        robot.pass(0.01);
      }
      const std::string what = std::to_string(wish.vx) + (odometry ? " with odometry" : "");
      EXPECT_LE(gap, 0.12) << what << ": it comes near";
      if (!odometry) continue;  // nobody knows whether it follows
      EXPECT_GT(least, 0.1) << what;
      EXPECT_LT(off, 0.2) << what;
    }
  }
}

TEST(GuardedDrives, FromAWallItCannotSeeAnyMoreItBacksOff) {
  GuardedRobot robot;
  robot.drives(Scene({wall_before(0.2)}), {0.1, 0.0, 0.0});
  Scene too_near({wall_before(0.1)});  // nearer than 0.4 m: nothing returns
  const Guarded& ahead = robot.drives(too_near, {0.1, 0.0, 0.0});
  EXPECT_EQ(ahead.cause, Cause::Blind) << ahead.reason;
  EXPECT_EQ(ahead.factor, 0.0);
  EXPECT_TRUE(ahead.stuck);
  EXPECT_EQ(ahead.open, backward);
  EXPECT_EQ(robot.drives(too_near, {-0.1, 0.0, 0.0}).factor, 1.0);
  EXPECT_NEAR(robot.drives(too_near, {-0.3, 0.0, 0.0}).given.linear[0], -0.1, 1e-9) << "at escape_speed";
  EXPECT_EQ(robot.drives(too_near, {0.0, 0.0, 0.3}).factor, 0.0) << "turning, it would lose where not to go";
}

TEST(GuardedDrives, OnceItSurelyStandsTheWayBackIsOpenWithoutOdometryToo) {
  const Scene nothing({wall_before(-0.2)});
  for (const double gap : {0.14, 0.185, 0.25}) {
    for (const double waits : {1.2, 3.0, 4.5, 8.0, 30.0}) {
      GuardedRobot robot;
      ASSERT_GT(robot.drives(Scene({wall_before(gap)}), {0.3, 0.0, 0.0}).factor, 0.0);
      for (double time = 0.0; time < waits; time += 0.05) robot.drives_on(nothing, {0.3, 0.0, 0.0});
      EXPECT_EQ(robot.wants({0.3, 0.0, 0.0}).open, backward) << gap << " after " << waits;
      for (int i = 0; i < 40; ++i) {
        const Guarded& back = robot.drives_on(nothing, {-0.1, 0.0, 0.0});
        ASSERT_EQ(back.factor, 1.0) << gap << " after " << waits << ": " << back.reason;
      }
    }
  }
}

TEST(GuardedDrives, BackwardWhereNobodyLooksItCreeps) {
  GuardedRobot robot;
  const Guarded& answer = robot.drives(Scene({post(3.0f, 0.0f)}), {-0.4, 0.0, 0.0});
  EXPECT_NEAR(answer.given.linear[0], -0.1, 1e-9);
  Settings never = guard_settings();
  never.unseen_speed = 0.0;
  GuardedRobot other(never);
  EXPECT_EQ(other.drives(Scene({post(3.0f, 0.0f)}), {-0.4, 0.0, 0.0}).factor, 0.0);
}

TEST(GuardedDrives, BackwardOnAnArcItCreepsTooThoughItsFrontSwingsIntoThePicture) {
  Settings rectangle = guard_settings();
  rectangle.footprint.text = "[[0.3, 0.12], [-0.1, 0.12], [-0.1, -0.12], [0.3, -0.12]]";
  for (const Settings& settings : {guard_settings(), rectangle}) {
    GuardedRobot robot(settings);
    const Guarded& answer = robot.drives(Scene(), {-0.55, 0.0, 0.61});
    EXPECT_LT(answer.factor, 0.25) << answer.reason;
    EXPECT_GT(answer.factor, 0.0) << answer.reason;
  }
}

TEST(GuardedDrives, SidewardItCreepsTooThoughAPartOfItSlidesIntoThePicture) {
  Settings never = guard_settings(), rectangle = guard_settings();
  never.unseen_speed = 0.0;
  rectangle.footprint.text = "[[0.3, 0.25], [-0.5, 0.25], [-0.5, -0.25], [0.3, -0.25]]";
  for (const Settings& settings : {guard_settings(), never, rectangle}) {
    for (const double ahead : {-0.02, 0.0, 0.01, 0.05}) {
      for (const double aside : {0.4, -0.7}) {
        GuardedRobot robot(settings);
        const Guarded& answer = robot.drives(Scene(), {ahead, aside, 0.0});
        EXPECT_LE(std::abs(answer.given.linear[1]), settings.unseen_speed + 1e-9) << ahead << " " << aside;
        EXPECT_EQ(answer.in_view, false);
      }
    }
  }
}

TEST(GuardedDrives, ARoundRobotTurnsFreelyInPlace) {
  GuardedRobot robot;
  EXPECT_EQ(robot.drives(Scene({wall_before(0.16)}), {0.0, 0.0, 1.5}).factor, 1.0);
  EXPECT_EQ(robot.drives(Scene(), {0.0, 0.0, -1.5}).factor, 1.0);
}

}  // namespace
}  // namespace safety_control_cloud
