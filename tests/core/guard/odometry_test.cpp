// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "driving_odometry.hpp"

namespace safety_control_cloud {
namespace {

TEST(Odometry, TellsTheWayBetweenAndBeyondItsPoses) {
  Odometry odometry;
  const Twist2 twist{0.4, 0.0, 0.5};
  drive(odometry, twist, 10.0, 1.0);
  expect_near(odometry.way_since(10.33, 11.1), way_of(twist, 0.77), 1e-4);
}

TEST(Odometry, WhatToldNonsenseGoesOnSinceItToldSenseAgain) {
  Odometry odometry;
  drive(odometry, {}, 10.0, 1.0);
  odometry.note(11.02, {{std::nan(""), 0.0}, 0.0}, {});
  EXPECT_EQ(odometry.breaks(), 1u);
  EXPECT_GT(odometry.goes_on_since(), 1e9) << "not since it began";
  drive(odometry, {}, 12.0, 0.1);
  EXPECT_EQ(odometry.goes_on_since(), 12.0);
}

/// As TF has it: of the pose alone.
TEST(Odometry, OfPosesAloneTellsTheSameWayAndTheTwistBetweenThem) {
  Odometry odometry;
  const Twist2 twist{0.4, 0.1, -2.0};
  for (int i = 0; i <= 100; ++i) {  // through half a turn, where headings are wrapped
    Pose2 pose = way_of(twist, 0.02 * i);
    pose.heading = std::remainder(pose.heading, 2.0 * std::acos(-1.0));
    odometry.note_pose(10.0 + 0.02 * i, pose, {0.7, 3.14});
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
    for (int i = 0; i < 10; ++i) odometry.note_pose(10.0 + 0.02 * i, {}, {0.7, 3.14});
    odometry.note_pose(10.2, odd, {0.7, 3.14});
    EXPECT_EQ(odometry.breaks(), std::size_t{1}) << odd.place.x << ' ' << odd.heading;
    EXPECT_FALSE(odometry.way_since(10.1, 10.2));
  }
  Odometry back;
  back.note_pose(10.0, {}, {0.7, 3.14});
  back.note_pose(9.0, {}, {0.7, 3.14});
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

/// Ten times a second.
TEST(Odometry, StaysFreshIfItWillBeUntilItIsHeardAgain) {
  Odometry odometry;
  for (int i = 0; i <= 20; ++i) odometry.note(10.0 + 0.1 * i, {}, {});
  EXPECT_TRUE(odometry.stays_fresh(12.14));
  EXPECT_TRUE(odometry.is_fresh(12.16));
  EXPECT_FALSE(odometry.stays_fresh(12.16));
  EXPECT_FALSE(odometry.stays_fresh(12.3));
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

/// The robot drove on at first, and then stood.
TEST(Odometry, GoesOnForWhoDidNotListenForAWhile) {
  const Twist2 twist{0.3, 0.0, 0.0};
  for (const double ahead : {0.0, 0.2, 1.0}) {
    Odometry odometry;
    drive(odometry, twist, 10.0, 1.0);
    odometry.note_deafness(11.0, 15.0);
    odometry.note(15.01, {{0.3 + ahead, 0.0}, 0.0}, {});
    EXPECT_EQ(odometry.breaks(), 0u) << ahead;
    EXPECT_NEAR(odometry.pose_at(15.01)->place.x, 0.3 + ahead, 1e-9);
  }
}

TEST(Odometry, WhatSkipsMoreThanTheWhileInWhichNobodyListenedOrGoesFartherBegan) {
  const Twist2 twist{0.3, 0.0, 0.0};
  const auto breaks_of = [&](double from, double until, double ahead) {
    Odometry odometry;
    drive(odometry, twist, 10.0, 1.0);
    odometry.note_deafness(from, until);
    odometry.note(15.01, {{0.3 + ahead, 0.0}, 0.0}, {});
    return odometry.breaks();
  };
  EXPECT_EQ(breaks_of(11.0, 15.0, 2.0), 1u) << "no twist explains that";
  EXPECT_EQ(breaks_of(11.0, 15.0, -9.0), 1u);
  EXPECT_EQ(breaks_of(11.0, 14.0, 0.2), 1u);
  EXPECT_EQ(breaks_of(12.0, 15.0, 0.2), 1u);
  EXPECT_EQ(breaks_of(1.0, 5.0, 0.2), 1u) << "long ago";
}

TEST(Odometry, AJumpIsToldOfForASecond) {
  Odometry odometry;
  drive(odometry, {}, 10.0, 1.0);
  EXPECT_EQ(odometry.doubt_at(11.0), std::nullopt);
  for (int i = 1; i <= 3; ++i) odometry.note(11.0 + 0.02 * i, {{i % 2 == 0 ? 0.0 : 1.0, 0.0}, 0.0}, {});
  EXPECT_EQ(odometry.doubt_at(11.06), "it did not go on from what it had told, for the 3. time");
  for (int i = 4; i <= 60; ++i) odometry.note(11.0 + 0.02 * i, {{1.0, 0.0}, 0.0}, {});
  EXPECT_TRUE(odometry.doubt_at(12.0));
  EXPECT_EQ(odometry.doubt_at(12.1), std::nullopt);
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

TEST(Odometry, HasJumpedWhoGoesOnElsewhereAndNotWhoPaused) {
  const auto after = [](double stamp, const Pose2& pose) {
    Odometry odometry;
    drive(odometry, {0.3, 0.0, 0.0}, 10.0, 1.0);
    odometry.note(stamp, pose, {});
    return odometry;
  };
  EXPECT_EQ(after(14.0, {{0.32, 0.0}, 0.0}).breaks(), std::size_t{1});
  EXPECT_EQ(after(14.0, {{0.32, 0.0}, 0.0}).jumps(), 0u);
  EXPECT_EQ(after(14.0, {{0.9, 0.0}, 0.0}).jumps(), 1u);
  EXPECT_EQ(after(11.02, {{0.3, 0.0}, 1.0}).jumps(), 1u);
  EXPECT_EQ(after(11.02, {{std::nan(""), 0.0}, 1.0}).jumps(), 1u) << "for all that is known";
}

}  // namespace
}  // namespace safety_control_cloud
