// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/known_places.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "robot_with_odometry.hpp"

namespace safety_control_cloud {
namespace {

const FieldOfView xtion_field{-0.577, 0.577, -0.433, 0.433};

/// A place that stands on the floor, so far ahead of the camera and to its right.
KnownPlace standing(float ahead, float right, double off = 0.01) {
  return {{}, Point(right, 0.35f * ahead, ahead), off};
}

std::vector<KnownPlace> standing_across(float ahead, float from, float to, double off = 0.01) {
  std::vector<KnownPlace> known;
  for (float right = from; right <= to; right += 0.01f) known.push_back(standing(ahead, right, off));
  return known;
}

TEST(Hides, WhatIsKnownToStandThereAndNothingElse) {
  const std::vector<Span> middle{{0.4, 0.6}};
  EXPECT_TRUE(hides(standing_across(0.36f, -0.05f, 0.05f), middle, xtion_field, 0.4));
  EXPECT_FALSE(hides(standing_across(0.36f, -0.05f, 0.0f), middle, xtion_field, 0.4)) << "half of it";
  EXPECT_FALSE(hides(standing_across(0.36f, 0.1f, 0.2f), middle, xtion_field, 0.4)) << "beside it";
  EXPECT_FALSE(hides(standing_across(0.5f, -0.1f, 0.1f), middle, xtion_field, 0.4)) << "there it would return";
  EXPECT_FALSE(hides(standing_across(0.36f, -0.05f, 0.05f, 0.1), middle, xtion_field, 0.4)) << "it may be anywhere";
  EXPECT_FALSE(hides({}, middle, xtion_field, 0.4));
  EXPECT_TRUE(hides({}, {}, xtion_field, 0.4)) << "nothing is hidden";
}

TEST(Hides, NoFloorIsHiddenByWhatHangsAboveIt) {
  std::vector<KnownPlace> board = standing_across(0.36f, -0.05f, 0.05f);
  for (KnownPlace& place : board) place.seen_from_camera.y = -0.1f;
  EXPECT_FALSE(hides(board, {{0.4, 0.6}}, xtion_field, 0.4));
}

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

/// In its picture it lies elsewhere than where it was lost.
TEST(LostSpots, WhatIsShownAgainJustThereIsKnown) {
  const Outlook camera({}, std::get<Placement>(xtion()));
  const Pose2 pose{{1.0, 2.0}, 0.5};
  const Point spot(0.1f, 0.0f, 0.6f);
  const Eye eye{{-0.087, 0.0}, {1.0, 0.0}, 0.5};
  LostSpots lost;
  lost.note({spot}, LostSpots::Before{camera, pose}, 10.0);
  const auto known_by = [&](double beside, double shown_at, double off = 0.0) {
    const KnownPlace place{{0.6 - 0.087, -0.1 + beside}, spot, off, shown_at};
    return lost.are_among({place}, pose, eye, 30.0, 15.0);
  };
  EXPECT_TRUE(known_by(0.03, 10.1)) << "it was shown there last";
  EXPECT_FALSE(known_by(0.03, 15.0)) << "as the rest of it is";
  EXPECT_TRUE(known_by(0.01, 15.0)) << "it is";
  EXPECT_FALSE(known_by(0.01, 15.0, 0.1)) << "nobody knows whether there";
}

/// A rod before a board: when its place is forgotten, that of the board, which was lost later, does not speak for it.
TEST(LostSpots, OneThatIsForgottenIsNotKnownByAllTheOthers) {
  const Outlook camera({}, std::get<Placement>(xtion()));
  const LostSpots::Before before{camera, {}};
  const Eye ahead_of_it{{-0.087, 0.0}, {1.0, 0.0}, 0.5}, aside{{-0.087, 0.0}, {0.0, 1.0}, 0.5};
  std::vector<Point> spots{{0.0f, 0.0f, 0.5f}};
  LostSpots lost;
  lost.note(spots, before, 10.0);
  std::vector<KnownPlace> board;
  for (int i = 0; i < 20; ++i) {
    const float aside_of_it = 0.01f * static_cast<float>(i - 10);
    spots.emplace_back(aside_of_it, 0.0f, 0.6f);
    board.push_back({{0.6 - 0.087, double{-aside_of_it}}, spots.back(), 0.0, 20.0});
  }
  lost.note(spots, before, 20.0);
  const auto are_known = [&](double now, const Eye& eye) { return lost.are_among(board, {}, eye, 30.0, now); };
  EXPECT_TRUE(are_known(39.0, ahead_of_it)) << "but for a few";
  EXPECT_FALSE(are_known(40.0, ahead_of_it));
  EXPECT_TRUE(are_known(40.0, aside)) << "where nobody drives";
  EXPECT_FALSE(are_known(60.0, ahead_of_it));
  EXPECT_TRUE(are_known(60.0, aside));
}

}  // namespace
}  // namespace safety_control_cloud
