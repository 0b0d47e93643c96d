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

/// Whatever returned around where it may be would show it: it would never be forgotten, and be anywhere by then.
TEST(OutOfSight, AWallFarBehindAThingThatHasGoneKeepsNothingWhosePlaceNobodyKnows) {
  for (const double drift : {0.02, 0.3}) {
    Settings settings = remembering(1.0);
    settings.odometry_drift = drift;
    RobotWithOdometry robot(settings);
    robot.passes(0.5, with_post);
    for (const double angle : {quarter, -quarter}) robot.turns(angle, robot.hall);
    robot.passes(40.0, Scene({wall_before(1.6f)}));
    robot.turns(quarter, robot.hall);
    EXPECT_EQ(robot.asked({0.0, -0.5, 0.0}).factor, 1.0) << drift << ": " << robot.wants({0.0, -0.5, 0.0}).reason;
  }
}

/// The front of a board, that may lie nearer by now and below the picture: what returns in its place may be the rest.
TEST(OutOfSight, WhatReturnsFromAPlaceThatIsNotWellKnownIsNotAllOfIt) {
  const auto factor_of = [](bool has_turned) {
    Settings settings = remembering();
    settings.odometry_drift = 0.1;
    RobotWithOdometry robot(settings);
    const Scene board({{0.59f, -0.05f, 0.05f, 0.17f, floor_y}});
    robot.passes(0.5, board);
    if (has_turned) {
      for (const double angle : {quarter, -quarter}) robot.turns(angle, robot.hall);
      robot.passes(0.5, board);
    }
    robot.turns(quarter, robot.hall);
    return robot.asked({0.0, -0.3, 0.0}).factor;
  };
  EXPECT_LT(factor_of(true), 0.9 * factor_of(false));
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

TEST(OutOfSight, OneStampOfOdometryFarAheadIsNotWaitedFor) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.control.note_odometry(robot.now.ros + 1000.0, robot.pose, {});
  robot.pass(0.05);
  EXPECT_EQ(robot.wants(left).cause, Cause::NoOdometry);
  EXPECT_EQ(robot.asked(left).factor, 1.0) << robot.wants(left).reason;
}

TEST(OutOfSight, OdometryWhoseClockIsSetAheadIsNotWaitedForEither) {
  for (const double ahead : {0.5, 2.0, 60.0, 3600.0}) {
    RobotWithOdometry robot;
    robot.passes(0.5, with_post);
    robot.turns(quarter, robot.hall);
    robot.odometry_ahead = ahead;
    EXPECT_EQ(robot.asked(left).factor, 1.0) << ahead << ": " << robot.wants(left).reason;
  }
}

/// A relay says some things twice, a driver of two threads some in another order.
TEST(OutOfSight, OdometryThatComesTwiceOrALittleLateForgetsNothing) {
  for (const double late : {0.0, 0.003, 0.02, 0.2}) {
    RobotWithOdometry robot;
    robot.passes(0.5, with_post);
    robot.turns(quarter, robot.hall);
    robot.passes(0.5, robot.hall);
    robot.control.note_odometry(robot.now.ros - late, robot.pose, robot.twist);
    EXPECT_LT(robot.asked({0.0, -0.7, 0.0}).factor, 0.95) << late << ": " << robot.wants({}).reason;
  }
}

/// Shown as it goes, too far away to be kept anew, and for longer than anything is kept.
TEST(OutOfSight, WhatIsSeenFartherAwayThanTheMemoryReachesHasNotGone) {
  for (const float away : {0.0f, 0.2f, 0.8f}) {
    RobotWithOdometry robot(remembering(1.0));
    robot.passes(0.5, with_post);
    const int steps = static_cast<int>(std::lround(away / 0.01f));
    robot.twist = {-0.2, 0.0, 0.0};
    for (int i = 1; i <= steps; ++i) {
      robot.pose.place.x -= 0.01;
      robot.passes(0.05, Scene({post(0.9f + 0.01f * static_cast<float>(i), 0.0f)}));
    }
    robot.twist = {};
    robot.passes(40.0, Scene({post(0.9f + away, 0.0f)}));
    robot.turns(quarter, robot.hall);
    robot.twist = {0.0, -0.2, 0.0};
    for (int i = 0; i < steps; ++i) {
      robot.pose.place.x += 0.01;
      robot.passes(0.05, robot.hall);
    }
    robot.twist = {};
    const Guarded& answer = robot.asked({0.0, -0.7, 0.0});
    EXPECT_LT(answer.factor, 0.95) << away << ": " << answer.reason;
    EXPECT_EQ(answer.sensor, "memory");
  }
}

/// A gripper before the camera, and a post that is seen beside it and then, once the robot has turned, behind it.
TEST(OutOfSight, WhatAPartOfTheRobotHidesHasNotGone) {
  for (const float width : {0.1f, 0.2f}) {
    Settings settings = remembering();
    settings.self_boxes.text = "[[0.33, 0.39, -0.15, 0.15, 0.0, 1.0]]";
    RobotWithOdometry robot(settings);
    const Board gripper{0.46f, -width / 2, width / 2, -0.2f, 0.2f};
    const Scene before({gripper, post(0.48f, 0.18f)}), after({gripper});
    robot.passes(0.5, before);
    robot.turns(-std::atan2(0.18, 0.393), after);
    robot.passes(1.0, after);
    const Guarded& answer = robot.wants({0.6, 0.0, 0.0});
    EXPECT_LT(answer.factor, 0.95) << width << ": " << answer.reason;
    EXPECT_EQ(answer.sensor, "memory");
    RobotWithOdometry alone(settings);
    alone.passes(1.0, after);
    EXPECT_EQ(alone.wants({0.6, 0.0, 0.0}).factor, 1.0) << "itself it does not stop for";
  }
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

TEST(OutOfSight, WhatIsSeenThroughIsForgotten) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.turns(-quarter, robot.hall);
  robot.passes(0.2, Scene({wall_before(1.5)}));
  robot.turns(quarter, robot.hall);
  EXPECT_EQ(robot.asked({0.0, -0.5, 0.0}).factor, 1.0) << robot.wants(right).reason;
}

/// Beyond the camera's range nothing returns from behind it.
TEST(OutOfSight, WhereNothingReturnsAnyMoreItIsForgottenAfterAWhile) {
  for (const double seconds : {0.5, 2.0}) {
    RobotWithOdometry robot;
    robot.passes(0.5, with_post);
    robot.passes(seconds, robot.hall);
    robot.turns(quarter, robot.hall);
    EXPECT_EQ(robot.asked({0.0, -0.7, 0.0}).factor < 1.0, seconds < 1.0) << robot.wants(right).reason;
  }
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

/// As a stereo camera gives them where something is too near for it.
TEST(OutOfSight, StrayReturnsDoNotEraseIt) {
  std::mt19937 random(7);
  RobotWithOdometry robot;
  const auto board_at = [](float distance) { return Scene({{distance, -0.3f, 0.3f, -0.3f, 0.25f}}); };
  robot.passes(0.5, board_at(0.6f));
  for (int i = 0; i < 10; ++i) {
    robot.pose.place.x += 0.025;
    robot.passes(0.05, board_at(0.6f - 0.025f * static_cast<float>(i + 1)));  // until it is too near
  }
  for (int i = 0; i < 400; ++i) robot.passes(0.05, board_at(0.35f).stray(0.1, random));
  robot.turns(quarter, robot.hall);
  const Guarded& answer = robot.asked({0.0, -0.7, 0.0});
  EXPECT_LT(answer.factor, 1.0) << answer.reason;
}

TEST(OutOfSight, AfterAJumpOfOdometryItStandsUntilEachSensorHasLooked) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.pose.place.x += 3.0;
  robot.pass(0.05);
  robot.control.note_odometry(robot.now.ros, robot.pose, {});
  const Guarded& answer = robot.wants(left);
  EXPECT_EQ(answer.cause, Cause::NoOdometry) << answer.reason;
  EXPECT_EQ(answer.factor, 0.0);
  robot.passes(0.1, robot.hall);
  EXPECT_EQ(robot.wants(left).factor, 1.0) << robot.wants(left).reason;
}

/// As one does that is corrected by a map, or whose driver starts anew while the robot stands.
TEST(OutOfSight, WhatIsKeptGoesOnAsTheBaseIsToldWhereOdometryJumpsOrPauses) {
  for (const double pause : {0.05, 2.0}) {
    RobotWithOdometry robot;
    robot.passes(0.5, with_post);
    robot.turns(quarter, robot.hall);
    robot.has_odometry = false;
    robot.passes(pause, robot.hall);
    robot.pose = {{3.0, -2.0}, 2.0};
    robot.has_odometry = true;
    const auto factor = [&](const Twist2& twist) {
      robot.passes(2.5, robot.hall);  // until whatever it was told before is over
      return robot.asked(twist).factor;
    };
    EXPECT_LT(factor({0.0, -0.7, 0.0}), 1.0) << robot.wants({}).reason;
    EXPECT_EQ(factor({0.0, 0.7, 0.0}), 1.0) << robot.wants({}).reason;
    robot.turns(quarter, robot.hall);
    EXPECT_LT(factor({-0.7, 0.0, 0.0}), 1.0) << robot.wants({}).reason;
    EXPECT_EQ(factor({0.0, -0.7, 0.0}), 1.0) << robot.wants({}).reason;
  }
}

/// A shelf at the height of its head, which is above the picture from 0.45 m on.
TEST(OutOfSight, WhatThePictureAheadDoesNotShowCountsWhileOdometryHasNotSpokenAgain) {
  Settings settings = remembering();
  settings.near_loss.distance = 0.0;
  RobotWithOdometry robot(settings);
  const auto shelf_at = [](float z) { return Scene({{z, -0.3f, 0.3f, -0.25f, -0.2f}}); };
  for (float z = 0.9f; z > 0.45f; z -= 0.05f, robot.pose.place.x += 0.05) {
    robot.twist = {1.0, 0.0, 0.0};
    robot.passes(0.05, shelf_at(z));
  }
  robot.twist = {};
  ASSERT_LT(robot.asked({0.5, 0.0, 0.0}).factor, 0.9) << robot.wants({}).reason;
  for (int i = 0; i < 30; ++i) {
    robot.pose.place.y += i % 3 == 0 ? 1.0 : 0.0;  // never for 0.2 s without a jump
    robot.passes(0.05, robot.hall);
    EXPECT_LT(robot.wants({0.5, 0.0, 0.0}).factor, 0.9) << i << ": " << robot.wants({}).reason;
    robot.wants({});
  }
}

/// What it was told until the next look counts.
TEST(OutOfSight, WhoDrivesWhileOdometryJumpsHasGoneOn) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.twist = {0.4, 0.0, 0.0};
  const auto drives = [&](int looks) {
    for (int i = 0; i < looks; ++i) {
      robot.pass(0.05);
      robot.pose = beyond(robot.pose, way_of(robot.twist, 0.05));
      robot.control.note_odometry(robot.now.ros, robot.pose, robot.twist);
      robot.see(robot.hall);
      robot.wants(robot.twist);
    }
  };
  drives(8);
  robot.pose = {{-5.0, 1.0}, -1.0};
  drives(8);
  robot.twist = {};
  const Guarded& answer = robot.asked({0.0, -0.7, 0.0});
  ASSERT_TRUE(answer.point) << answer.reason;
  EXPECT_NEAR(answer.point->x, -16 * 0.05 * 0.4, 0.1) << answer.reason;
}

/// Who never had any hears nothing of it.
TEST(OutOfSight, OdometryThatIsNotBelievedIsTold) {
  RobotWithOdometry robot, without;
  without.has_odometry = false;
  robot.passes(0.5, robot.hall), without.passes(0.5, without.hall);
  EXPECT_TRUE(robot.wants({}).doubts.empty() && without.wants({}).doubts.empty());
  robot.has_odometry = false;
  robot.passes(0.5, robot.hall);
  const auto doubts = robot.wants({}).doubts;
  ASSERT_EQ(doubts.size(), std::size_t{1});
  EXPECT_NE(doubts[0].find("odometry: its latest stamp is 0.5"), std::string::npos) << doubts[0];
  EXPECT_NE(doubts[0].find(" s old"), std::string::npos) << doubts[0];
  robot.control.note_odometry(robot.now.ros + 0.4, robot.pose, {});
  EXPECT_EQ(robot.wants({}).doubts, std::vector<std::string>{"odometry: its latest stamp is 0.400 s ahead"});
}

TEST(OutOfSight, WithoutOdometryThatWasThereItStandsUntilTheirTimeEnds) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.has_odometry = false;
  EXPECT_EQ(robot.asked(left).cause, Cause::NoOdometry);
  robot.passes(29.0, robot.hall);
  EXPECT_EQ(robot.asked(left).factor, 1.0) << robot.wants(left).reason;
}

TEST(OutOfSight, WhoNeverHadOdometryDrivesByWhatHeSees) {
  RobotWithOdometry robot;
  robot.has_odometry = false;
  robot.passes(0.5, with_post);
  EXPECT_EQ(robot.asked(left).factor, 1.0);
}

TEST(OutOfSight, ResetForgets) {
  RobotWithOdometry robot;
  robot.passes(0.5, with_post);
  robot.turns(quarter, robot.hall);
  robot.control.forget_losses();
  EXPECT_EQ(robot.asked({0.0, -0.7, 0.0}).factor, 1.0);
}

/// Who drives off with the first cloud, before odometry has gone on for long enough to be asked.
TEST(OutOfSight, WhatWasSeenBeforeOdometryIsAskedIsPlacedByItToo) {
  const double distance = 0.813, rate = 1.5;
  const auto turned = [&](double first, bool from_the_start) {
    RobotWithOdometry robot;
    const auto seen = [&] {
      const double heading = robot.pose.heading;
      return Scene({post(static_cast<float>(distance * std::cos(heading) + 0.087),
                         static_cast<float>(distance * std::sin(heading)))});
    };
    if (!from_the_start) robot.passes(1.0, seen());
    robot.twist = {0.0, 0.0, rate};
    while (robot.pose.heading < first) {
      robot.pass(0.05);
      robot.pose.heading += 0.05 * rate;
      robot.control.note_odometry(robot.now.ros, robot.pose, robot.twist);
      robot.see(seen());
      robot.wants(robot.twist);
    }
    robot.turns(quarter - robot.pose.heading, robot.hall);
    return robot.asked({0.0, -0.7, 0.0});
  };
  const Guarded known = turned(0.3, false), reckoned = turned(0.3, true);
  for (const Guarded* one : {&known, &reckoned}) {
    ASSERT_TRUE(one->point) << one->reason;
    EXPECT_EQ(one->sensor, "memory");
    EXPECT_NEAR(one->point->x, 0.0, 0.05) << one->reason;
    EXPECT_NEAR(one->point->y, -distance, 0.05) << one->reason;
  }
  EXPECT_GT(known.factor, 0.0);
  EXPECT_NEAR(reckoned.factor, known.factor, 0.02);
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

/// It may lie beside where it is looked for, outside the picture.
TEST(OutOfSight, WhereOdometryMayHaveDriftedALookPastAPlaceProvesTheLess) {
  const double aside = 0.4;  // [rad]
  for (const double drift : {0.0, 0.05}) {
    Settings settings = remembering();
    settings.odometry_drift = drift;
    RobotWithOdometry robot(settings);
    robot.passes(0.5, with_post);
    const Scene wall({wall_before(1.5)});
    for (int i = 0; i < 3; ++i) robot.turns(quarter, robot.hall);
    robot.turns(quarter - aside, wall);
    robot.passes(1.0, wall);
    const Twist2 there{0.6 * std::cos(aside), 0.6 * std::sin(aside), 0.0};
    EXPECT_EQ(robot.wants(there).factor<1.0, drift> 0.0) << robot.wants(there).reason;
  }
}

}  // namespace
}  // namespace safety_control_cloud
