// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

/// A robot that drives up to what is so far ahead of its camera until that is too near for it.
void drives_up(RobotWithOdometry& robot, Scene (*at)(float)) {
  constexpr float first = 0.8f, last = 0.36f, step = 0.01f;
  for (float ahead = first; ahead >= last; ahead -= step) {
    robot.passes(0.05, at(ahead));
    robot.pose.place.x += double{step};
  }
  robot.pose.place.x -= double{step};
  robot.passes(2.0, at(last));  // until it stands
}

Scene post_at(float ahead) { return Scene({post(ahead, 0.02f, 0.06f)}); }
Scene board_at(float ahead) { return Scene({{ahead, -0.3f, 0.3f, -0.3f, 0.05f}}); }

const Twist2 ahead{0.3, 0.0, 0.0}, about{0.0, 0.0, 1.0}, away{-0.05, 0.0, 0.3};

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

Scene wall_at(float ahead) { return Scene({{ahead, -9.0f, 9.0f, -9.0f, floor_y}}); }

TEST(Blindness, BeforeAWallThatIsKnownClosesOnlyTheWayAhead) {
  RobotWithOdometry robot, without;
  without.has_odometry = false;
  for (RobotWithOdometry* one : {&robot, &without}) drives_up(*one, wall_at);
  EXPECT_GT(robot.wants(about).factor, 0.0) << robot.wants(about).reason;
  EXPECT_GT(robot.wants(away).factor, 0.0) << robot.wants(away).reason;
  const Guarded& answer = robot.wants({0.02, 0.0, 0.3});
  EXPECT_EQ(answer.factor, 0.0);
  EXPECT_EQ(answer.cause, Cause::Blind) << "somebody may have stepped between";
  ASSERT_EQ(answer.doubts.size(), std::size_t{1});
  EXPECT_NE(answer.doubts[0].find("BLIND"), std::string::npos) << answer.doubts[0];
  EXPECT_EQ(without.wants(about).cause, Cause::Blind);
  EXPECT_EQ(without.wants(about).factor, 0.0);
}

TEST(Blindness, OfWhichOnlyAPartIsKnownClosesAllButTheWayBack) {
  RobotWithOdometry post, none;
  drives_up(post, board_at);
  none.passes(1.0, none.hall);
  for (RobotWithOdometry* robot : {&post, &none}) {
    robot->passes(0.3, wall_at(0.3f));
    EXPECT_EQ(robot->wants(about).cause, Cause::Blind);
    EXPECT_EQ(robot->wants(about).factor, 0.0);
    EXPECT_EQ(robot->wants({-0.05, 0.0, 0.0}).factor, 1.0) << robot->wants({-0.05, 0.0, 0.0}).reason;
  }
}

/// Over the wall's top a quarter of the picture returns: this is no camera that sees nothing for what it stands before.
TEST(Blindness, OfACameraThatReturnsMuchIsOfAnotherCause) {
  Settings settings = remembering();
  settings.min_valid_ratio = 0.9;
  RobotWithOdometry robot(settings);
  drives_up(robot, [](float ahead) {
    return Scene({{3.0f, -9.0f, 9.0f, -9.0f, floor_y}, {ahead, -9.0f, 9.0f, -0.08f, floor_y}});
  });
  EXPECT_EQ(robot.wants(about).cause, Cause::Blind);
  EXPECT_EQ(robot.wants(about).factor, 0.0);
}

TEST(Blindness, OutlivesAChangeOfSettings) {
  const Twist2 back{-0.05, 0.0, 0.0};
  RobotWithOdometry robot, without;
  without.has_odometry = false;
  for (RobotWithOdometry* one : {&robot, &without}) {
    drives_up(*one, wall_at);
    one->control.adopt(remembering(1.4));
    for (const Twist2& wish : {about, back}) EXPECT_EQ(one->wants(wish).cause, Cause::NoCloud);
    one->passes(0.3, wall_at(0.36f));
    EXPECT_EQ(one->wants(back).factor, 1.0) << one->wants(back).reason;
    EXPECT_EQ(one->wants(ahead).factor, 0.0);
  }
  EXPECT_GT(robot.wants(about).factor, 0.0) << robot.wants(about).reason;
  EXPECT_EQ(without.wants(about).factor, 0.0);
}

/// What is known lies before it no more, and it is dark still.
TEST(Blindness, ThatGoesOnWhereTheWallIsNotIsOfAnotherCause) {
  RobotWithOdometry robot;
  drives_up(robot, wall_at);
  ASSERT_GT(robot.wants(about).factor, 0.0);
  robot.turns(quarter, wall_at(0.3f));
  EXPECT_EQ(robot.wants(about).cause, Cause::Blind);
  EXPECT_EQ(robot.wants(about).factor, 0.0);
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

/// A camera that rests goes on seeing what rests where it sees.
TEST(LostSpots, WhatRestedRightBeyondTheBlindRangeAndThenCameNearerIsNotKnownToRestThere) {
  for (const float rested : {0.41f, 0.42f, 0.44f}) {
    for (const float came_to : {0.26f, 0.34f}) {
      RobotWithOdometry robot;
      const auto board = [](float at) {
        return Scene({{at, -0.06f, 0.06f, -0.05f, 0.08f}, {2.5f, -9.0f, 9.0f, -9.0f, floor_y}});
      };
      for (float at = 1.2f; at > rested; at -= 0.03f) robot.passes(0.05, board(at));
      robot.passes(1.0, board(rested));
      EXPECT_EQ(robot.wants(about).factor, 1.0) << rested;
      robot.passes(1.0, board(came_to));
      EXPECT_EQ(robot.wants(ahead).factor, 0.0) << rested << ", " << came_to;
      EXPECT_EQ(robot.wants(ahead).cause, Cause::NearLoss) << rested << ", " << came_to;
      robot.passes(1.0, wall_at(2.5f));
      EXPECT_EQ(robot.wants(ahead).factor, 1.0) << rested << ", " << robot.wants(ahead).reason;
    }
  }
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
