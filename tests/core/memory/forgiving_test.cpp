// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/forgiving.hpp"

#include <gtest/gtest.h>

#include "../input/cloud_builder.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::size_t columns = 160, rows = 120;
const Outlook ahead;
const Xyz none{nan, nan, nan};

/// A picture of a wall at 2 m, but for the columns in which something else is seen.
struct Shown {
  std::vector<Xyz> points = std::vector<Xyz>(columns * rows, Xyz{0.0f, 0.0f, 2.0f});

  Shown with(std::size_t first, std::size_t last, const Xyz& point) const {
    Shown other = *this;
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t column = first; column <= last; ++column) other.points[row * columns + column] = point;
    return other;
  }
  Pixels picture() const {
    CloudView view = view_of(points);
    view.width = columns, view.height = rows, view.row_step = columns * sizeof(Xyz);
    return Pixels(view, 0.0f);
  }
};
const Shown wall;

Spot spot_at(std::size_t column, bool stands = false) {
  Spot spot;
  spot.row = 60, spot.column = static_cast<std::uint16_t>(column);
  spot.point = {0.0f, 0.0f, 0.4f};
  spot.share = 1.0f, spot.company = 9, spot.stands = stands;
  return spot;
}

/// A thing that is lost, ten spots of it in the middle of the picture.
struct Lost : Remembered {
  explicit Lost(bool stands = false) {
    for (std::size_t i = 0; i < 10; ++i) lost.push_back(spot_at(75 + i, stands));
  }
  std::size_t left_after(const Shown& shown, const Outlook& outlook = ahead, bool floor_is_seen = false) {
    const std::vector<std::size_t> floor_rows;
    Gaze gaze(outlook, {});
    gaze.has_turned = has_turned;
    forgive(*this, shown.picture(), {[=](std::size_t) { return floor_is_seen; }, floor_rows}, gaze);
    return lost.size();
  }

  bool has_turned = false;  ///< the camera
};

TEST(Forgiving, WhatIsSeenPastAsAWholeHasGoneAtOnce) {
  Lost thing;
  EXPECT_EQ(thing.left_after(wall), 0u);
}

TEST(Forgiving, WhatIsSeenPastInPartsGoesPartByPartInThreeSuccessiveClouds) {
  Lost thing;
  const Shown half = wall.with(80, 90, none);
  EXPECT_EQ(thing.left_after(half), 10u);
  EXPECT_EQ(thing.left_after(half), 10u);
  EXPECT_EQ(thing.left_after(half), 6u) << "all but those beside the hole";
  EXPECT_DOUBLE_EQ(thing.freed, 4.0);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(thing.left_after(half), 6u);
}

TEST(Forgiving, OneCloudThatSaysNothingBeginsItAnew) {
  Lost thing;
  const Shown half = wall.with(80, 90, none), all = wall.with(70, 90, none);
  for (int i = 0; i < 10; ++i) {
    for (const Shown& shown : {half, half, all}) EXPECT_EQ(thing.left_after(shown), 10u);
  }
}

TEST(Forgiving, AHoleThatIsLeftOfItStaysLost) {
  Lost thing;
  const Shown mostly = wall.with(83, 87, none);
  for (int i = 0; i < 20; ++i) thing.left_after(mostly);
  ASSERT_FALSE(thing.lost.empty());
  EXPECT_GE(thing.lost.front().column, 81);
}

TEST(Forgiving, WhatIsSeenAgainIsNotLostAndCountsAsNotGone) {
  Lost thing;
  EXPECT_EQ(thing.left_after(wall.with(70, 90, {0.0f, 0.0f, 0.4f})), 0u);
  EXPECT_EQ(thing.freed, 0.0);
}

TEST(Forgiving, WhatHidesItSaysNothing) {
  Lost thing;
  for (int i = 0; i < 20; ++i) EXPECT_EQ(thing.left_after(wall.with(70, 90, {0.0f, 0.0f, 0.2f})), 10u);
}

TEST(Forgiving, ACameraThatLooksElsewhereSaysNothingOfWhatLiesNobodyKnowsWhere) {
  Lost thing;
  const Shown nothing = wall.with(70, 90, none);
  ASSERT_EQ(thing.left_after(nothing), 10u);
  const Outlook left({}, Placement{{{{0.995f, 0, -0.1f, 0}, {0, 1, 0, 0}, {0.1f, 0, 0.995f, 0}}}});
  for (int i = 0; i < 20; ++i) EXPECT_EQ(thing.left_after(wall, left), 10u);
  EXPECT_EQ(thing.left_after(wall), 0u);
}

/// It is asked about once the camera looks there again; what was seen while that turned may never be.
TEST(Forgiving, WhatThePictureDoesNotShowStaysThoughNearlyAllHasGone) {
  const Outlook left({}, Placement{{{{0.995f, 0, -0.1f, 0}, {0, 1, 0, 0}, {0.1f, 0, 0.995f, 0}}}});
  for (const float turning : {0.0f, 0.05f}) {
    Lost thing;
    thing.lost[9].camera = camera_pose_of(left);
    thing.lost[9].turning = turning;
    for (int i = 0; i < 5; ++i) thing.left_after(wall);
    EXPECT_EQ(thing.lost.size(), turning == 0.0f ? 1u : 0u);
  }
}

TEST(Forgiving, OnePictureOfACameraThatTurnsMayBeOfAnotherDirectionThanItIsSaid) {
  Lost thing;
  thing.has_turned = true;
  EXPECT_EQ(thing.left_after(wall), 10u);
  EXPECT_EQ(thing.left_after(wall), 0u);
}

TEST(Forgiving, WhatStoodGoesWhereTheFloorIsSeenAgainThoughNothingIsBehindIt) {
  const Shown hall = wall.with(0, columns - 1, none);
  Lost standing(true), hanging;
  EXPECT_EQ(standing.left_after(hall, ahead, true), 0u);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(hanging.left_after(hall, ahead, true), 10u);
}

/// Of the ten one lies in a hole.
TEST(Forgiving, WhatHungNeitherGoesAlongWithWhatStoodBelowItNorKeepsThat) {
  for (const bool hung : {true, false}) {
    Lost thing;
    thing.lost[9].column = 95;
    thing.lost[9].hung_before = hung;
    const Shown hole = wall.with(90, 100, none);
    EXPECT_EQ(thing.left_after(hole), hung ? 1u : 10u);
    for (int i = 0; i < 20; ++i) thing.left_after(hole);
    ASSERT_EQ(thing.lost.size(), 1u);
    EXPECT_EQ(thing.lost[0].column, 95);
  }
}

/// A wall that went out of the corridor, say as the robot backed off: its lowest spot, 0.5 m away, lies where what
/// comes nearer leaves the picture. Above that it was so far away [m], and seen last in this picture.
struct LostWall : Remembered {
  LostWall(float above, std::uint32_t picture_above) {
    for (const std::uint16_t row : {std::uint16_t{95}, lowest}) {
      Spot spot = spot_at(80, true);
      const bool is_lowest = row == lowest;
      spot.row = row, spot.point.z = is_lowest ? 0.5f : above, spot.picture = is_lowest ? 7 : picture_above;
      if (!is_lowest) spot.share = 0.1f;  // or the lowest goes along, as the small rest of it
      lost.push_back(spot);
    }
  }
  std::size_t left_after(const Shown& shown) {
    const std::vector<std::size_t> floor_rows;
    forgive(*this, shown.picture(), {[](std::size_t) { return true; }, floor_rows}, Gaze(ahead, {}, 0.07f));
    return lost.size();
  }

  static constexpr std::uint16_t lowest = 115;
};

TEST(Forgiving, TheLowestOfAWallIsThereWhereItIsStillThereRightAboveThat) {
  const Shown beside_the_corridor = wall.with(75, 85, {0.0f, 0.0f, 0.525f});
  EXPECT_EQ(LostWall(0.5f, 7).left_after(beside_the_corridor), 0u);
  EXPECT_EQ(LostWall(0.55f, 7).left_after(beside_the_corridor), 1u) << "it is another one";
  EXPECT_EQ(LostWall(0.5f, 9).left_after(beside_the_corridor), 1u) << "it was seen later";
  EXPECT_EQ(LostWall(0.5f, 0).left_after(beside_the_corridor), 1u) << "nobody knows when it was seen";
}

}  // namespace
}  // namespace safety_control_cloud
