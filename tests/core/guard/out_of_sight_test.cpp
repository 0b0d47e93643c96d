// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/out_of_sight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

const Twist2 right{0.0, -0.5, 0.0}, left{0.0, 0.5, 0.0};

TEST(OutOfSight, WhatHasLeftThePictureStaysWhereItWas) {
  RobotWithOdometry robot, to_the_left, without(remembering(0.0));
  for (RobotWithOdometry* one : {&robot, &to_the_left, &without}) {
    one->passes(0.5, with_post);
    one->turns(quarter, one->hall);
  }
  const Guarded& answer = robot.asked({0.0, -0.7, 0.0});
  EXPECT_LT(answer.factor, 0.95) << answer.reason;
  EXPECT_EQ(answer.sensor, "memory");
  ASSERT_TRUE(answer.point);
  EXPECT_NEAR(answer.point->y, -0.9 + 0.087, 0.06);
  EXPECT_NEAR(answer.point->x, 0.0, 0.12);
  EXPECT_EQ(to_the_left.asked(left).factor, 1.0) << "nothing is there";
  EXPECT_EQ(without.asked({0.0, -0.7, 0.0}).factor, 1.0);
}

TEST(OutOfSight, WhatWouldFreeWhoStandsForItIsSaid) {
  RobotWithOdometry robot;
  robot.passes(0.5, Scene({post(0.45f, 0.0f)}));
  robot.turns(quarter, robot.hall);
  EXPECT_EQ(robot.wants({0.0, -0.02, 0.0}).hint, "") << "it does not stand";
  for (int i = 0; i < 14; ++i) {
    robot.pose.place.x += 0.01;
    robot.passes(0.05, robot.hall);
  }
  const Guarded& answer = robot.asked({0.0, -0.7, 0.0});
  EXPECT_EQ(answer.factor, 0.0);
  EXPECT_EQ(answer.sensor, "memory");
  EXPECT_NE(answer.hint.find("memory_time"), std::string::npos) << answer.hint;
}

const Twist2 back{-0.3, 0.0, 0.0}, ahead{0.3, 0.0, 0.0};

Settings among_people(double speed) {
  Settings settings = remembering();
  settings.obstacle_speed = speed;
  return settings;
}

void shows_somebody_who_walks_out_of_the_picture(RobotWithOdometry& robot) {
  for (float beside = 0.3f; beside < 0.8f; beside += 0.015f) robot.passes(0.05, Scene({post(0.8f, beside)}));
  robot.passes(3.0, robot.hall);
}

/// Where somebody looks he would be seen.
TEST(OutOfSight, WhoWalkedOnMayBeWhereNobodyLooks) {
  for (const bool has_odometry : {true, false}) {
    RobotWithOdometry robot(among_people(0.3)), resting(among_people(0.0));
    robot.has_odometry = resting.has_odometry = has_odometry;
    for (RobotWithOdometry* one : {&robot, &resting}) shows_somebody_who_walks_out_of_the_picture(*one);
    EXPECT_EQ(resting.wants(back).factor, 1.0) << "nothing moves";
    EXPECT_EQ(robot.wants(ahead).factor, 1.0) << robot.wants(ahead).reason;
    EXPECT_EQ(robot.wants(back).factor, 0.0);
    EXPECT_EQ(robot.wants(back).sensor, "memory");
    EXPECT_NE(robot.wants(back).hint.find("memory_time"), std::string::npos);
    robot.passes(30.0, robot.hall);
    EXPECT_EQ(robot.wants(back).factor, 1.0) << robot.wants(back).reason;
  }
}

/// He may stand right beside the robot, where the picture of a robot that turns sharply shows him too late.
TEST(OutOfSight, WhoTurnsSharplyAmongPeopleCreeps) {
  Settings settings = among_people(0.3);
  settings.unseen_speed = 0.1;
  RobotWithOdometry robot(settings);
  shows_somebody_who_walks_out_of_the_picture(robot);
  EXPECT_LT(robot.wants({0.3, 0.0, 1.5}).factor, 0.6);
  EXPECT_GT(robot.wants({0.3, 0.0, 1.5}).factor, 0.0);
  EXPECT_EQ(robot.wants({0.3, 0.0, 0.2}).factor, 1.0) << robot.wants({0.3, 0.0, 0.2}).reason;
}

TEST(OutOfSight, WhoStaysInThePictureIsNotElsewhere) {
  RobotWithOdometry robot(among_people(0.3));
  for (int i = 0; i < 200; ++i)
    robot.passes(0.05, Scene({post(1.0f + 0.2f * static_cast<float>(i % 40) / 40.0f, 0.0f)}));
  EXPECT_EQ(robot.wants(back).factor, 1.0) << robot.wants(back).reason;
}

TEST(OutOfSight, WhoWalkedOnMayHaveFollowed) {
  RobotWithOdometry robot(among_people(0.5));
  shows_somebody_who_walks_out_of_the_picture(robot);
  robot.twist = {0.4, 0.0, 0.0};
  for (int i = 0; i < 300; ++i) {
    robot.pose.place.x += 0.02;
    robot.passes(0.05, robot.hall);
  }
  robot.twist = {};
  robot.passes(3.0, robot.hall);
  EXPECT_EQ(robot.wants(back).factor, 0.0) << robot.wants(back).reason;
}

/// Away from where who is not known to stay was last, a robot may leave.
TEST(OutOfSight, WhatStoodForAWhileIsWhereItStood) {
  const auto factor_after = [](double seconds) {
    RobotWithOdometry robot(among_people(0.3));
    robot.passes(seconds, with_post);
    robot.turns(quarter, robot.hall);
    robot.passes(3.0, robot.hall);
    return robot.wants(back).factor;
  };
  EXPECT_EQ(factor_after(1.5), 1.0);
  EXPECT_LE(factor_after(0.5), among_people(0.3).escape_speed / 0.3 + 1e-9);
}

/// However little odometry is trusted: where a thing is is known the less, and it counts the more.
TEST(OutOfSight, OdometryThatDriftsLetsNothingBeForgotten) {
  double before = 1.0;
  for (const double drift : {0.02, 0.1, 0.3, 1.0}) {
    Settings settings = remembering();
    settings.odometry_drift = drift;
    RobotWithOdometry robot(settings);
    robot.passes(0.5, with_post);
    robot.turns(quarter, robot.hall);
    const double factor = robot.asked({0.0, -0.7, 0.0}).factor;
    EXPECT_LE(factor, before) << drift;
    before = factor;
  }
  EXPECT_LT(before, 0.5);
}

/// Which the robot comes near to only then: it lies beside where it is taken to be by as much as it did as he turned.
TEST(OutOfSight, WhoTurnsFarFromAThingKnowsTheLessWhereItIs) {
  const auto factor_of = [](bool turns_far_away) {
    Settings settings = remembering();
    settings.odometry_drift = 0.05;
    RobotWithOdometry robot(settings);
    robot.passes(0.5, Scene({post(1.3f, 0.0f)}));
    robot.turns(quarter, robot.hall);
    const auto turns_to_and_fro = [&](bool now) {
      for (const double angle : {quarter, -quarter})
        if (now) robot.turns(angle, robot.hall);
    };
    turns_to_and_fro(turns_far_away);
    robot.twist = {0.0, -0.2, 0.0};
    for (int i = 0; i < 70; ++i) {
      robot.pose.place.x += 0.01;
      robot.passes(0.05, robot.hall);
    }
    robot.twist = {};
    turns_to_and_fro(!turns_far_away);
    return robot.asked({0.0, -0.5, 0.0}).factor;
  };
  EXPECT_LT(factor_of(true), 0.9 * factor_of(false));
}

/// As in UTM coordinates.
TEST(OutOfSight, OdometryThatBeginsFarAwayIsAsGood) {
  RobotWithOdometry robot;
  robot.pose = {{5.2e5, 5.4e6}, 2.5};
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  const Guarded& answer = robot.asked({0.0, -0.7, 0.0});
  ASSERT_TRUE(answer.point) << answer.reason;
  EXPECT_NEAR(answer.point->y, -0.9 + 0.087, 0.06);
  EXPECT_NEAR(answer.point->x, 0.0, 0.12);
}

/// Of too many places those nearby are kept, however long before others have come.
TEST(OutOfSight, WhatIsNearIsKeptHoweverMuchIsRemembered) {
  Settings settings = remembering();
  settings.memory_time = 600.0;
  RobotWithOdometry robot(settings);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> beside(-0.8f, 0.8f), ahead(0.7f, 1.4f);
  for (int i = 0; i < 400; ++i) {  // through a wood
    std::vector<Board> posts;
    for (int j = 0; j < 6; ++j) posts.push_back(post(ahead(random), beside(random), 0.3f));
    robot.pose.place.x += 3.0;
    robot.twist = {60.0, 0.0, 0.0};
    robot.passes(0.15, Scene(posts));
  }
  robot.twist = {};
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  EXPECT_LT(robot.asked({0.0, -0.7, 0.0}).factor, 0.95) << robot.wants({}).reason;
}

TEST(OutOfSight, ItsTimeEnds) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.passes(26.0, robot.hall);
  EXPECT_LT(robot.asked({0.0, -0.7, 0.0}).factor, 1.0);
  robot.passes(4.0, robot.hall);
  EXPECT_EQ(robot.asked({0.0, -0.7, 0.0}).factor, 1.0);
}

TEST(OutOfSight, WhatLiesAboveOrBelowTheRobotByNowIsNotKept) {
  for (const auto& [bottom, top] : {std::pair(0.02, 0.42), std::pair(0.05, 0.15), std::pair(0.35, 0.42)}) {
    Settings settings = remembering();
    RobotWithOdometry robot(settings);
    robot.passes(0.5, Scene({{0.9f, -0.05f, 0.05f, floor_y - 0.3f, floor_y - 0.2f}}));
    robot.turns(quarter, robot.hall);
    settings.frame_corridor.bottom = bottom, settings.frame_corridor.top = top;
    robot.control.adopt(settings);
    EXPECT_EQ(robot.asked({0.0, -0.7, 0.0}).factor < 1.0, bottom < 0.03) << bottom << " to " << top;
  }
}

TEST(OutOfSight, WhatWasFartherIsNotKept) {
  RobotWithOdometry robot;
  robot.passes(0.5, Scene({post(1.8f, 0.0f)}));
  robot.turns(quarter, robot.hall);
  EXPECT_EQ(robot.asked({0.0, -0.7, 0.0}).factor, 1.0);
}

TEST(OutOfSight, OneStrayReturnIsNothing) {
  RobotWithOdometry robot;
  robot.passes(0.05, with_post);
  robot.turns(quarter, robot.hall);
  EXPECT_EQ(robot.asked({0.0, -0.7, 0.0}).factor, 1.0) << robot.wants(right).reason;
}

/// Of which each by itself is no jump.
TEST(OutOfSight, WhatNoMotionOfOdometryExplainsAddsUp) {
  double before = 1.0;
  for (const int jumps : {0, 2, 4}) {
    RobotWithOdometry robot;
    robot.passes(0.5, with_post);
    robot.turns(quarter, robot.hall);
    for (int i = 0; i < jumps; ++i) {
      robot.pose.place.x -= 0.09;  // away from the post
      robot.passes(0.5, robot.hall);
    }
    const double factor = robot.asked({0.0, -0.7, 0.0}).factor;
    EXPECT_LE(factor, before) << jumps;
    before = factor;
  }
  EXPECT_LT(before, 1.0);
}

/// A camera whose clock lies behind: where the robot was when it looked is known the less.
TEST(OutOfSight, AStampThatMayBeOffPlacesAThingTheLessSurely) {
  for (const double behind : {0.0, 0.5}) {
    RobotWithOdometry robot;
    robot.stamp_behind = behind;
    robot.passes(1.0, robot.hall);
    robot.turns(quarter, with_post);
    robot.turns(quarter, robot.hall);
    const Guarded& answer = robot.asked({0.0, -0.7, 0.0});
    EXPECT_LT(answer.factor, 0.95) << behind << ": " << answer.reason;
  }
}

/// Turns from where it stands, before odometry tells of it that comes so late [s], and then wants to go to its right,
/// where a post stands by then that was straight ahead.
Guarded turned_away_from_a_post(double late, bool tells_twists) {
  const double distance = 0.813, rate = 2.5, period = 0.05;
  RobotWithOdometry robot;
  robot.has_odometry = false;
  std::vector<std::pair<Pose2, Twist2>> said;
  const auto goes_on = [&](double turning) {
    robot.twist = {0.0, 0.0, turning};
    robot.pose.heading += period * turning;
    said.emplace_back(robot.pose, robot.twist);
    const auto ago = static_cast<std::size_t>(std::lround(late / period));
    if (said.size() > ago) {
      const auto& [pose, twist] = said[said.size() - 1 - ago];
      robot.control.note_odometry(robot.now.ros + period - late, pose, tells_twists ? twist : Twist2{});
    }
    const double heading = robot.pose.heading;
    robot.pass(period);
    robot.see(Scene({post(static_cast<float>(distance * std::cos(heading) + 0.087),
                          static_cast<float>(distance * std::sin(heading))),
                     wall_before(2.5)}));
    robot.wants({0.0, 0.0, turning});
  };
  for (int i = 0; i < 30; ++i) goes_on(0.0);
  const double at_once = tells_twists ? rate : 10.0 * period;  // of who tells none, more is a jump
  for (double turning = 0.0; robot.pose.heading < quarter; turning = std::min(rate, turning + at_once))
    goes_on(turning);
  for (int i = 0; i < 30; ++i) goes_on(0.0);
  return robot.wants({0.0, -0.7, 0.0});
}

TEST(OutOfSight, WhatLeavesThePictureBeforeLateOdometryTellsOfTheTurnIsNotLost) {
  const double on_time = turned_away_from_a_post(0.0, true).factor;
  EXPECT_LT(on_time, 0.95);
  for (const double late : {0.1, 0.15, 0.2}) {
    for (const bool tells_twists : {true, false}) {
      const Guarded answer = turned_away_from_a_post(late, tells_twists);
      EXPECT_EQ(answer.sensor, "memory") << late << answer.reason;
      EXPECT_LE(answer.factor, on_time) << late << (tells_twists ? "" : " without twists") << answer.reason;
    }
  }
}

}  // namespace
}  // namespace safety_control_cloud
