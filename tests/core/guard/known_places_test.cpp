// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../../../safety_control_cloud/core/text/words.hpp"
#include "driving_up.hpp"

namespace safety_control_cloud {
namespace {

TEST(LostSpots, WhatIsTooNearClosesOnlyTheWayThereIfItsPlaceIsKnown) {
  for (const auto& at : {post_at, board_at}) {
    RobotWithOdometry robot, without;
    without.has_odometry = false;
    for (RobotWithOdometry* one : {&robot, &without}) drives_up(*one, at);
    EXPECT_EQ(robot.wants(about).factor, 1.0) << robot.wants(about).reason;
    EXPECT_EQ(robot.wants(away).factor, 1.0) << robot.wants(away).reason;
    const Guarded& answer = robot.wants(ahead);
    EXPECT_LT(answer.factor, 0.8);
    EXPECT_EQ(answer.sensor, "memory");
    EXPECT_NEAR(answer.point->x, 0.36 - 0.087, 0.03);
    EXPECT_EQ(without.wants(about).cause, Cause::NearLoss);
    EXPECT_EQ(without.wants(about).factor, 0.0);
  }
}

/// Where it was when it was blind, nobody asked: by where it was before, this one were where another is known to be.
TEST(LostSpots, WhatCameNearBeforeABlindCameraOfARobotThatBacksOffIsUnknown) {
  const Board person = {0.3f, -0.4f, 0.14f, -1.0f, floor_y};
  const auto other = [](float ahead) { return Board{ahead, 0.1f, 0.24f, -0.3f, 0.05f}; };
  RobotWithOdometry robot;
  robot.passes(1.0, board_at(0.45f));
  for (int i = 0; i < 30; ++i) {
    robot.pose.place.x -= 0.01;
    robot.passes(0.05, Scene({person}));
  }
  for (float ahead = 0.6f; ahead > 0.41f; ahead -= 0.03f) robot.passes(0.05, Scene({person, other(ahead)}));
  robot.passes(0.3, Scene({person, other(0.36f)}));
  ASSERT_EQ(robot.wants(about).cause, Cause::Blind);
  robot.passes(0.1, Scene({{0.75f, -0.3f, 0.3f, -0.3f, 0.05f}, other(0.36f)}));
  EXPECT_EQ(robot.wants(about).cause, Cause::NearLoss);
  EXPECT_EQ(robot.wants(about).factor, 0.0);
}

/// A niche in a wall is in sight for longer than the wall, and goes out of it while the camera is blind.
TEST(LostSpots, WhatCameNearBeforeABlindCameraOfARobotThatGoesOnIsKnown) {
  const auto right_half = [](float ahead) {
    return std::vector<Board>{{ahead, 0.05f, 0.15f, -9.0f, floor_y},
                              {ahead + 0.06f, 0.15f, 0.19f, -9.0f, floor_y},
                              {ahead, 0.19f, 9.0f, -9.0f, floor_y}};
  };
  const auto both = [&](float ahead) {
    std::vector<Board> boards = right_half(ahead);
    boards.push_back({ahead, -9.0f, 0.05f, -9.0f, floor_y});
    return Scene(boards);
  };
  RobotWithOdometry robot;
  float ahead = 0.8f;
  for (; ahead > 0.33f; ahead -= 0.01f) {
    robot.passes(0.05, both(ahead));
    robot.pose.place.x += 0.01;
  }
  robot.passes(1.0, both(ahead));  // until it stands
  ASSERT_EQ(robot.wants({0.02, 0.0, 0.3}).cause, Cause::Blind);
  std::vector<Board> boards = right_half(ahead);
  boards.push_back({3.0f, -9.0f, 9.0f, -9.0f, floor_y});
  robot.passes(0.2, Scene(boards));
  EXPECT_NE(robot.wants(about).cause, Cause::NearLoss) << robot.wants(about).reason;
  EXPECT_GT(robot.wants(about).factor, 0.0) << robot.wants(about).reason;
  EXPECT_LT(robot.wants({0.3, 0.0, 0.0}).factor, 0.2);
}

TEST(LostSpots, WhatElseHidesTheFloorIsUnknown) {
  RobotWithOdometry robot;
  drives_up(robot, post_at);
  ASSERT_EQ(robot.wants(about).factor, 1.0);
  robot.passes(0.2, Scene({post(0.36f, 0.02f, 0.06f), post(0.3f, -0.1f)}));
  EXPECT_EQ(robot.wants(about).cause, Cause::NearLoss);
  EXPECT_EQ(robot.wants(about).factor, 0.0);
  robot.passes(0.2, post_at(0.36f));
  EXPECT_EQ(robot.wants(about).factor, 1.0) << robot.wants(about).reason;
}

/// Whoever walks through leaves places behind that were shown for a moment.
TEST(LostSpots, WhatWalkedIntoTheBlindZoneIsNotKnownByItsTrail) {
  RobotWithOdometry robot;
  robot.passes(0.5, robot.hall);
  for (float ahead = 1.2f; ahead >= 0.36f; ahead -= 0.03f) robot.passes(0.05, post_at(ahead));
  robot.passes(1.0, post_at(0.3f));
  EXPECT_EQ(robot.wants(about).cause, Cause::NearLoss);
  EXPECT_EQ(robot.wants(about).factor, 0.0);
}

Scene board_before_wall_at(float ahead) {
  return Scene({{ahead, -0.06f, 0.06f, -0.05f, 0.08f}, {2.5f, -9.0f, 9.0f, -9.0f, floor_y}});
}

/// Comes there and rests.
void comes_to(RobotWithOdometry& robot, float rests) {
  for (float at = 1.2f; at > rests; at -= 0.03f) robot.passes(0.05, board_before_wall_at(at));
  robot.passes(1.0, board_before_wall_at(rests));
}

void expect_is_closed_until_it_leaves(RobotWithOdometry& robot, const std::string& by) {
  EXPECT_EQ(robot.wants(ahead).factor, 0.0) << by;
  EXPECT_EQ(robot.wants(ahead).cause, Cause::NearLoss) << by;
  robot.passes(1.0, wall_at(2.5f));
  EXPECT_EQ(robot.wants(ahead).factor, 1.0) << by << ": " << robot.wants(ahead).reason;
}

/// A camera that rests goes on seeing what rests where it sees.
TEST(LostSpots, WhatRestedRightBeyondTheBlindRangeAndThenCameNearerIsNotKnownToRestThere) {
  for (const float rested : {0.41f, 0.42f, 0.44f}) {
    for (const float came_to : {0.26f, 0.34f}) {
      RobotWithOdometry robot;
      comes_to(robot, rested);
      EXPECT_EQ(robot.wants(about).factor, 1.0) << rested;
      robot.passes(1.0, board_before_wall_at(came_to));
      expect_is_closed_until_it_leaves(robot, words(rested, ", ", came_to));
    }
  }
}

TEST(LostSpots, WhatRestedAndComesBackAfterALookPastThatDidNotRestMeanwhile) {
  RobotWithOdometry robot;
  comes_to(robot, 0.402f);
  for (const float at : {0.55f, 0.402f}) robot.passes(0.05, board_before_wall_at(at));
  robot.passes(1.0, board_before_wall_at(0.3f));
  expect_is_closed_until_it_leaves(robot, "out and back");
}

TEST(LostSpots, WhatMayMoveIsNotKnownForLong) {
  Settings settings = remembering();
  settings.obstacle_speed = 0.3;
  RobotWithOdometry robot(settings);
  drives_up(robot, post_at);
  EXPECT_EQ(robot.wants(about).cause, Cause::NearLoss);
}

TEST(LostSpots, AfterAJumpOfOdometryNobodyKnowsWhereTheyAre) {
  RobotWithOdometry robot;
  drives_up(robot, post_at);
  ASSERT_EQ(robot.wants(about).factor, 1.0);
  robot.pose.place.y += 2.0;
  robot.passes(0.05, post_at(0.36f));
  EXPECT_EQ(robot.wants(about).factor, 0.0);
  robot.passes(1.0, post_at(0.36f));
  EXPECT_EQ(robot.wants(about).cause, Cause::NearLoss);
  robot.pose.place.y -= 2.0;
  robot.passes(1.0, post_at(0.36f));
  EXPECT_EQ(robot.wants(about).cause, Cause::NearLoss) << "it could as well be elsewhere";
}

/// By then none of what is lost is kept as a place.
TEST(LostSpots, AfterAPauseOfOdometryNobodyKnowsWhereTheyAreHoweverOldTheyAre) {
  for (const double seconds : {0.35, 2.0}) {
    RobotWithOdometry robot;
    drives_up(robot, board_at);
    robot.passes(35.0, board_at(0.36f));
    robot.has_odometry = false;
    robot.passes(seconds, board_at(0.36f));
    robot.has_odometry = true;
    robot.pose = {{-3.0, 1.0}, 1.6};
    robot.passes(3.0, board_at(0.36f));
    EXPECT_EQ(robot.wants(ahead).cause, Cause::NearLoss) << seconds << ": " << robot.wants(ahead).reason;
  }
}

TEST(LostSpots, ThoseOfBeforeARestartHaveNoPlace) {
  RobotWithOdometry robot, next;
  drives_up(robot, board_at);
  ASSERT_TRUE(next.control.recall(robot.control.remembered()));
  next.passes(0.5, board_at(0.36f));
  EXPECT_EQ(next.wants(about).cause, Cause::NearLoss);
}

/// A hall in which nothing is ever seen behind a board.
TEST(LostSpots, WhatIsNotBeforeTheCameraIsForgottenAfterAWhileAndNoSooner) {
  RobotWithOdometry turned, facing;
  for (RobotWithOdometry* robot : {&turned, &facing}) drives_up(*robot, board_at);
  turned.turns(quarter, turned.hall);
  EXPECT_EQ(turned.asked(ahead).factor, 1.0) << turned.wants(ahead).reason;
  turned.passes(35.0, turned.hall);
  EXPECT_EQ(turned.asked(ahead).factor, 1.0) << turned.wants(ahead).reason;
  facing.passes(35.0, board_at(0.36f));
  EXPECT_EQ(facing.wants(ahead).factor, 0.0) << facing.wants(ahead).reason;
}

/// A pallet, as a camera sees it from above: a front, and farther and farther parts of its top.
Scene pallet_at(float ahead) {
  std::vector<Board> boards{{3.0f, -9.0f, 9.0f, -9.0f, floor_y}, {ahead, -0.3f, 0.3f, 0.15f, floor_y}};
  for (float z = ahead + 0.02f; z < ahead + 0.6f; z += 0.02f)  // as high as no ray passes between
    boards.push_back({z, -0.3f, 0.3f, 0.15f * z / (z + 0.02f), 0.15f});
  return Scene(boards);
}

/// What is left between its hull and the pallet [m], once it has driven up to it, stood so long and gone on for a
/// while.
double left_before_a_pallet(double stood) {
  RobotWithOdometry robot;
  drives_up(robot, pallet_at);
  float ahead = 0.36f;
  robot.passes(stood, pallet_at(ahead));
  for (int i = 0; i < 100; ++i) {
    const double way = 0.05 * 0.2 * robot.wants({0.2, 0.0, 0.0}).factor;
    robot.pose.place.x += way;
    ahead -= static_cast<float>(way);
    robot.passes(0.05, pallet_at(ahead));
  }
  return double{ahead} - 0.087 - 0.178;
}

/// The rest of a long thing is in view as long as its end is not.
TEST(LostSpots, TheEndOfALongThingIsNotKnownByTheRestOfIt) {
  for (const double stood : {0.5, 3.0, 31.5}) EXPECT_GT(left_before_a_pallet(stood), 0.03) << stood;
}

}  // namespace
}  // namespace safety_control_cloud
