// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../memory/lens.hpp"
#include "robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

const Twist2 back{-0.6, 0.0, 0.0};

/// Turned by what it is told.
struct RobotWithoutOdometry : RobotWithOdometry {
  explicit RobotWithoutOdometry(const Settings& settings = remembering()) : RobotWithOdometry(settings) {
    has_odometry = false;
  }

  void turns_around(const Scene& scene, double speed = 0.5, double angle = 2.0 * quarter) {
    for (double t = 0.0; t < angle / std::abs(speed); t += 0.05) drives_on(scene, {0.0, 0.0, speed});
    passes(1.0, scene);
  }
};

TEST(WithoutOdometry, ItStaysByWhatTheBaseIsToldAndCountsWhereNobodyLooks) {
  RobotWithoutOdometry robot, without;
  robot.passes(0.5, with_post);
  for (RobotWithoutOdometry* one : {&robot, &without}) one->turns_around(one->hall);
  const Guarded& answer = robot.asked({-0.6, 0.0, 0.0});
  EXPECT_LT(answer.factor, 0.95) << answer.reason;
  EXPECT_EQ(answer.sensor, "memory");
  EXPECT_EQ(without.asked({-0.6, 0.0, 0.0}).factor, 1.0);
  EXPECT_EQ(robot.asked({0.6, 0.0, 0.0}).factor, 1.0) << "the camera looks there";
}

TEST(WithoutOdometry, WhatIsSeenThroughIsForgotten) {
  RobotWithoutOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns_around(robot.hall);
  robot.turns_around(Scene({wall_before(1.5)}), -0.5);
  robot.turns_around(robot.hall);
  EXPECT_EQ(robot.asked({-0.6, 0.0, 0.0}).factor, 1.0) << robot.wants({-0.6, 0.0, 0.0}).reason;
}

/// Its frame is another one.
TEST(WithoutOdometry, OnceItSpeaksWhatIsRememberedGoesOnInItsFrame) {
  RobotWithoutOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns_around(robot.hall);
  robot.has_odometry = true;
  robot.pose = {{30.0, -7.0}, 1.0};
  EXPECT_LT(robot.asked({-0.6, 0.0, 0.0}).factor, 0.95) << robot.wants({-0.6, 0.0, 0.0}).reason;
  EXPECT_GT(robot.asked({0.6, 0.0, 0.0}).factor, 0.0) << robot.wants({0.6, 0.0, 0.0}).reason;
  robot.turns(quarter, robot.hall);
  EXPECT_EQ(robot.asked({-0.6, 0.0, 0.0}).factor, 1.0) << "from now on by odometry";
  const Guarded& answer = robot.asked({0.0, 0.6, 0.0});
  ASSERT_TRUE(answer.point) << answer.reason;
  EXPECT_NEAR(std::hypot(answer.point->x, answer.point->y), 0.9 - 0.087, 0.1);
}

TEST(WithoutOdometry, WhatIsBesideItCountsForWhoDrivesSideways) {
  RobotWithoutOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns_around(robot.hall, 0.5, quarter);
  EXPECT_LT(robot.asked({0.0, -0.6, 0.0}).factor, 0.95) << robot.wants({0.0, -0.6, 0.0}).reason;
}

/// The camera sees its front corners turn, and not the rear one that swings into the post. Ahead it may go all the
/// same.
TEST(WithoutOdometry, WhatIsBesideARectangleCountsForItsTurnInPlace) {
  Settings rectangle = remembering();
  rectangle.footprint.text = "[[0.2, 0.21], [-0.4, 0.21], [-0.4, -0.21], [0.2, -0.21]]";
  for (const bool is_there : {true, false}) {
    RobotWithoutOdometry robot(rectangle);
    robot.passes(0.5, is_there ? Scene({post(0.5f, 0.0f)}) : Scene());
    robot.turns_around(robot.hall, 0.5, 2.2);  // to the left: what was ahead is behind its right side
    const Twist2 turn{0.0, 0.0, 1.0};
    EXPECT_EQ(robot.asked(turn).factor < 0.9, is_there) << robot.wants(turn).reason;
    EXPECT_EQ(robot.asked({0.6, 0.0, 0.0}).factor, 1.0) << robot.wants({0.6, 0.0, 0.0}).reason;
  }
}

/// The camera looks ahead, and what it drove past does not stand there any more: it stands before its right flank.
TEST(WithoutOdometry, WhatHasLeftThePictureBesideItCountsForTheArcThatLeadsThere) {
  for (const bool is_there : {true, false}) {
    RobotWithoutOdometry robot;
    const float first = 0.6f, right = 0.22f, step = 0.015f;
    for (float ahead = first; ahead > 0.3f; ahead -= step) {
      const bool in_picture = is_there && ahead > 0.4f;
      robot.drives_on(in_picture ? Scene({post(ahead, right)}) : robot.hall, {0.3, 0.0, 0.0});
    }
    const Guarded& answer = robot.drives_on(robot.hall, {0.3, 0.0, -1.2});
    EXPECT_EQ(answer.factor < 0.5, is_there) << answer.reason;
    EXPECT_EQ(answer.sensor == "memory", is_there);
    for (int i = 0; i < 20; ++i) robot.drives_on(robot.hall, {});
    for (const Twist2& away : {Twist2{-0.1, 0.0, 0.0}, Twist2{0.0, 0.0, 0.5}, Twist2{0.0, 0.0, -0.5}})
      EXPECT_EQ(robot.drives_on(robot.hall, away).factor, 1.0) << robot.wants(away).reason;
  }
}

/// Its rear swings out to what it has driven past.
TEST(WithoutOdometry, WhatIsBesideTheTailCountsForTheArcThatLeadsAwayFromIt) {
  Settings rectangle = remembering();
  rectangle.footprint.text = "[[0.2, 0.15], [-0.5, 0.15], [-0.5, -0.15], [0.2, -0.15]]";
  for (const bool is_there : {true, false}) {
    RobotWithoutOdometry robot(rectangle);
    for (float ahead = 0.9f; ahead > -0.2f; ahead -= 0.015f) {
      const bool in_picture = is_there && ahead > 0.5f;
      robot.drives_on(in_picture ? Scene({post(ahead, -0.28f)}) : robot.hall, {0.3, 0.0, 0.0});
    }
    const Guarded& answer = robot.drives_on(robot.hall, {0.3, 0.0, -1.2});
    EXPECT_EQ(answer.factor < 0.5, is_there) << answer.reason;
    EXPECT_EQ(robot.drives_on(robot.hall, {0.3, 0.0, 0.0}).factor, 1.0) << robot.wants({0.3, 0.0, 0.0}).reason;
  }
}

/// 17 cm thick, before a wall.
std::vector<Board> round_post(double z, double x) {
  constexpr double radius = 0.086;
  std::vector<Board> boards{wall_before(2.5)};
  for (double beside = -0.08; beside < 0.085; beside += 0.01) {
    const double front = z - std::sqrt(radius * radius - beside * beside);
    boards.push_back(post(static_cast<float>(front), static_cast<float>(x + beside), 0.0101f));
  }
  return boards;
}

/// Of the pixels around its edge some show it still, and some the wall behind it.
TEST(WithoutOdometry, WhoTurnsBeforeAPostDoesNotLoseAnEdgeOfItForGood) {
  const Lens lens;
  for (const double turning : {0.6, -0.6, 0.4}) {
    for (const double ahead : {0.55, 0.6, 0.65, 0.8}) {
      RobotWithoutOdometry robot;
      double heading = 0.0;
      for (int i = 0; i < 30 && std::abs(heading) < 0.4; ++i) {
        const double z = ahead * std::cos(heading), x = ahead * std::sin(heading);
        const auto points = lens.points(round_post(z, x));
        robot.pass(0.1);
        robot.see(lens.view_of_rows(points));
        const Guarded& answer = robot.wants({0.0, 0.0, i < 5 ? 0.0 : turning});
        heading += 0.1 * answer.given.angular[2];
      }
      EXPECT_GE(std::abs(heading), 0.4) << turning << ", " << ahead << ": " << robot.wants({0.0, 0.0, turning}).reason;
    }
  }
}

TEST(WithoutOdometry, OneMessageIsNone) {
  RobotWithoutOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns_around(robot.hall);
  robot.control.note_odometry(robot.now.ros, {{3.0, 1.0}, 0.5}, {});
  robot.passes(1.0, robot.hall);
  EXPECT_LT(robot.asked(back).factor, 0.95) << robot.wants(back).reason;
}

TEST(WithoutOdometry, WhatFellSilentLongAgoIsNone) {
  RobotWithoutOdometry robot;
  robot.has_odometry = true;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.has_odometry = false;
  robot.passes(40.0, robot.hall);
  robot.passes(0.5, with_post);
  robot.turns_around(robot.hall);
  EXPECT_LT(robot.asked(back).factor, 0.95) << robot.wants(back).reason;
}

/// The camera sees the upper part of it, which tells where it is.
TEST(WithoutOdometry, TheFootOfWhatStandsInThePictureDoesNotCountBelowIt) {
  const auto post_at = [](double ahead) { return Scene({post(static_cast<float>(ahead), 0.0f, 0.06f)}); };
  RobotWithoutOdometry robot, late;
  double ahead = 0.9;
  while (ahead > 0.55) ahead -= 0.05 * 0.2 * robot.drives_on(post_at(ahead), {0.2, 0.0, 0.0}).factor;
  for (RobotWithoutOdometry* one : {&robot, &late}) one->passes(1.0, post_at(ahead));
  const Twist2 on{0.5, 0.0, 0.0};
  EXPECT_DOUBLE_EQ(robot.drives_on(post_at(ahead), on).factor, late.drives_on(post_at(ahead), on).factor);
}

/// It has turned away and back, and nobody knows well where that stands. The camera would see its lower part.
TEST(WithoutOdometry, TheHeadOfWhatStandsOnTheFloorDoesNotCountAboveThePicture) {
  RobotWithoutOdometry robot;
  robot.passes(0.5, Scene({post(0.5f, 0.0f, 0.06f)}));
  for (const double turning : {0.6, -0.6}) robot.turns_around(robot.hall, turning, 0.9);
  for (int i = 0; i < 20; ++i) robot.drives_on(robot.hall, {0.2, 0.0, 0.0});
  robot.passes(0.5, robot.hall);
  EXPECT_EQ(robot.drives_on(robot.hall, {0.3, 0.0, 0.0}).factor, 1.0) << robot.wants({0.3, 0.0, 0.0}).reason;
}

/// It braked at once, or late and slowly.
TEST(WithoutOdometry, WhatIsBesideThePictureMayBeNearerThanItMostLikelyIsToWhoTurnsThere) {
  Settings settings = remembering();
  settings.unseen_speed = 0.1;
  RobotWithoutOdometry robot(settings);
  for (float ahead = 0.8f; ahead > 0.5f; ahead -= 0.015f)
    robot.drives_on(ahead > 0.7f ? Scene({post(ahead, 0.33f)}) : robot.hall, {0.3, 0.0, 0.0});
  robot.passes(1.0, robot.hall);
  EXPECT_LT(robot.drives_on(robot.hall, {0.3, 0.0, -0.9}).factor, 0.9);
  EXPECT_EQ(robot.drives_on(robot.hall, {0.3, 0.0, -0.2}).factor, 1.0) << robot.wants({0.3, 0.0, -0.2}).reason;
}

/// Who turns around a post that has left the picture beside it is clear of where that most likely is, or he is not.
TEST(WithoutOdometry, WhatMayBeNearerThanItMostLikelyIsIsCreptPast) {
  Settings settings = remembering();
  settings.footprint.text = "[[0.23, 0.21], [-0.23, 0.21], [-0.23, -0.21], [0.23, -0.21]]";
  for (const double unseen_speed : {0.1, 0.0}) {
    settings.unseen_speed = unseen_speed;
    for (const float right : {0.36f, 0.32f, 0.28f}) {
      RobotWithoutOdometry robot(settings);
      for (float ahead = 1.0f; ahead > 0.2f; ahead -= 0.015f)
        robot.drives_on(ahead > 0.6f ? Scene({post(ahead, right)}) : robot.hall, {0.3, 0.0, 0.0});
      robot.passes(0.5, robot.hall);
      const Twist2 around{0.2, 0.0, -0.5};
      const double creeping = right > 0.3f ? unseen_speed / (0.2 + 0.5 * std::hypot(0.23, 0.21)) : 0.0;
      const Guarded& answer = robot.drives_on(robot.hall, around);
      EXPECT_NEAR(answer.factor, creeping, 0.03) << right << ": " << answer.reason;
      EXPECT_EQ(answer.sensor, "memory");
    }
  }
}

/// It has turned to and fro since: who is well known to be beside the way is driven past, who is not may be nearer.
TEST(WithoutOdometry, WhatIsBesideThePictureAndNotWellKnownIsCreptPast) {
  const Twist2 there{0.3, 0.0, -0.2};
  for (const int turns : {0, 2}) {
    Settings settings = remembering();
    settings.unseen_speed = 0.1;
    RobotWithoutOdometry robot(settings);
    for (float ahead = 0.8f; ahead > 0.35f; ahead -= 0.015f)
      robot.drives_on(ahead > 0.7f ? Scene({post(ahead, 0.33f)}) : robot.hall, {0.3, 0.0, 0.0});
    for (int i = 0; i < turns; ++i)
      for (const double turning : {0.5, -0.5}) robot.turns_around(robot.hall, turning, 0.5);
    robot.passes(1.0, robot.hall);
    double least = 1.0;
    for (int k = 0; k < 10; ++k) least = std::min(least, robot.drives_on(robot.hall, there).factor);
    const double creeping = settings.unseen_speed / (0.3 + 0.2 * 0.178);
    EXPECT_NEAR(least, turns > 0 ? creeping : 1.0, 1e-3) << robot.wants(there).reason;
  }
}

/// Slower than anybody drives, for as long as it takes.
TEST(WithoutOdometry, WhoCreepsDrivesToo) {
  RobotWithoutOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns_around(robot.hall);
  for (int i = 0; i < 80; ++i) robot.drives_on(robot.hall, {-0.2, 0.0, 0.0});
  ASSERT_EQ(robot.wants(back).factor, 0.0) << robot.wants(back).reason;
  robot.passes(1.0, robot.hall);
  EXPECT_EQ(robot.wants({-0.0019, 0.0, 0.0}).factor, 0.0) << robot.wants({-0.0019, 0.0, 0.0}).reason;
}

/// For as long as it is remembered.
TEST(WithoutOdometry, WhatMayBeAnywhereByNowStopsWhoDrivesWhereNobodyLooks) {
  Settings settings = remembering();
  settings.memory_time = 600.0;
  RobotWithoutOdometry robot(settings);
  robot.passes(0.5, with_post);
  for (int i = 0; i < 1200; ++i) {
    robot.pass(0.4);
    robot.see(robot.hall);
    robot.wants({0.5, 0.0, i % 2 == 0 ? 1.0 : -1.0});
  }
  EXPECT_EQ(robot.wants(back).factor, 0.0);
  EXPECT_EQ(robot.wants(back).reason, "something was near, and may be anywhere by now");
  EXPECT_EQ(robot.drives(robot.hall, {0.3, 0.0, 0.0}).factor, 1.0) << robot.wants({0.3, 0.0, 0.0}).reason;
}

/// It comes so late that now and then its latest stamp is too old.
TEST(WithoutOdometry, OdometryThatComesTooLateIsAsNone) {
  for (const auto& [period, late] : {std::pair{0.1, 0.24}, std::pair{0.2, 0.16}, std::pair{0.05, 0.3}}) {
    RobotWithoutOdometry robot;
    double told = robot.now.ros;
    for (int i = 0; i < 2000; ++i) {
      robot.pass(0.01);
      for (; told + period <= robot.now.ros - late; told += period) robot.control.note_odometry(told + period, {}, {});
      if (i % 5 == 0) robot.see(with_post);
      const Guarded& answer = robot.wants({-0.1, 0.0, 0.0});
      if (i <= 100) continue;
      ASSERT_EQ(answer.cause, Cause::Seen) << period << " " << late << " " << i << ": " << answer.reason;
    }
  }
}

}  // namespace
}  // namespace safety_control_cloud
