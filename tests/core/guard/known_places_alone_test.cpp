// SPDX-License-Identifier: BSD-3-Clause
// The functions themselves; what becomes of a robot by them: known_places_test.cpp.
#include <gtest/gtest.h>

#include <variant>
#include <vector>

#include "../../../safety_control_cloud/core/guard/lost_spots.hpp"
#include "xtion.hpp"

namespace safety_control_cloud {
namespace {

constexpr double camera_height = 0.2972;  // xtion.hpp
const FieldOfView xtion_field{-0.577, 0.577, -0.433, 0.433};

/// A place that stands on the floor, so far ahead of the camera and to its right.
KnownPlace standing(float ahead, float right, double off = 0.01) {
  return {{}, 0.0, Point(right, 0.35f * ahead, ahead), off};
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

/// In its picture it lies elsewhere than where it was lost.
TEST(LostSpots, WhatIsShownAgainJustThereIsKnown) {
  const Outlook camera({}, std::get<Placement>(xtion()));
  const Pose2 pose{{1.0, 2.0}, 0.5};
  const Point spot(0.1f, 0.0f, 0.6f);
  const Eye eye{{-0.087, 0.0}, {1.0, 0.0}, 0.5};
  LostSpots lost;
  lost.note_picture(1, {camera, pose, 10.0});
  lost.note({{spot, 1}}, 10.0);
  const auto known_by = [&](double beside, double shown_at, double off = 0.0, double above = 0.0) {
    const KnownPlace place{{0.6 - 0.087, -0.1 + beside}, camera_height + above, spot, off, shown_at};
    return lost.are_among({place}, {pose, camera, xtion_field, eye, 0.4}, 30.0, 15.0);
  };
  EXPECT_TRUE(known_by(0.03, 10.1)) << "it was shown there last";
  EXPECT_FALSE(known_by(0.03, 15.0)) << "as the rest of it is";
  EXPECT_TRUE(known_by(0.01, 15.0)) << "it is";
  EXPECT_FALSE(known_by(0.01, 15.0, 0.1)) << "nobody knows whether there";
  EXPECT_TRUE(known_by(0.03, 10.1, 0.0, -0.09)) << "one height of so much is kept";
  EXPECT_FALSE(known_by(0.03, 10.1, 0.0, -0.15)) << "what stands below";
  EXPECT_FALSE(known_by(0.01, 15.0, 0.0, 0.15)) << "what hangs above";
}

/// A camera would go on showing what rests a little beyond its blind range.
TEST(LostSpots, WhatWouldBeShownIfItStillRestedBesideThemTellsNothing) {
  const Outlook camera({}, std::get<Placement>(xtion()));
  const Eye eye{{-0.087, 0.0}, {1.0, 0.0}, 0.5};
  const Looking looking{{}, camera, xtion_field, eye, 0.4};
  const Point spot(0.0f, 0.0f, 0.404f);
  LostSpots lost;
  lost.note_picture(1, {camera, {}, 10.0});
  lost.note({{spot, 1}}, 10.03);
  const auto are_known_at = [&](double now, float rested) {
    const Point there(0.0f, 0.0f, rested);
    return lost.are_among({{{double{rested} - 0.087, 0.0}, camera_height, there, 0.0, 9.97}}, looking, 30.0, now);
  };
  EXPECT_TRUE(are_known_at(10.03, 0.44f)) << "it has only just gone";
  EXPECT_FALSE(are_known_at(10.2, 0.44f));
  EXPECT_TRUE(are_known_at(10.2, 0.403f)) << "it may rest where the camera is blind";
}

/// A rod before a board: when its place is forgotten, that of the board, which was lost later, does not speak for it.
TEST(LostSpots, OneThatIsForgottenIsNotKnownByAllTheOthers) {
  const Outlook camera({}, std::get<Placement>(xtion()));
  const Eye ahead_of_it{{-0.087, 0.0}, {1.0, 0.0}, 0.5}, aside{{-0.087, 0.0}, {0.0, 1.0}, 0.5};
  std::vector<LostSpot> spots{{{0.0f, 0.0f, 0.5f}, 1}};
  LostSpots lost;
  lost.note_picture(1, {camera, {}, 10.0});
  lost.note(spots, 10.0);
  std::vector<KnownPlace> board;
  for (int i = 0; i < 20; ++i) {
    const float aside_of_it = 0.01f * static_cast<float>(i - 10);
    spots.push_back({{aside_of_it, 0.0f, 0.6f}, 2});
    board.push_back({{0.6 - 0.087, double{-aside_of_it}}, camera_height, spots.back().point, 0.0, 20.0});
  }
  lost.note_picture(2, {camera, {}, 20.0});
  lost.note(spots, 20.0);
  const auto are_known = [&](double now, const Eye& eye) {
    return lost.are_among(board, {{}, camera, xtion_field, eye, 0.4}, 30.0, now);
  };
  EXPECT_TRUE(are_known(39.0, ahead_of_it)) << "but for a few";
  EXPECT_FALSE(are_known(40.0, ahead_of_it));
  EXPECT_TRUE(are_known(40.0, aside)) << "where nobody drives";
  EXPECT_FALSE(are_known(60.0, ahead_of_it));
  EXPECT_TRUE(are_known(60.0, aside));
}

/// Few spots are kept over a restart, and many are lost since.
TEST(LostSpots, OneThatHasNoPlaceIsNotKnownByAllTheOthers) {
  const Outlook camera({}, std::get<Placement>(xtion()));
  const Eye eye{{-0.087, 0.0}, {1.0, 0.0}, 0.5};
  for (const bool any_of_before : {false, true}) {
    std::vector<LostSpot> spots;
    if (any_of_before) spots.push_back({{0.0f, 0.0f, 0.3f}, 0});
    LostSpots lost;
    lost.note(spots, 10.0);
    std::vector<KnownPlace> person;
    for (int i = 0; i < 30; ++i) {
      const Point seen(0.005f * static_cast<float>(i - 15), 0.0f, 0.38f);
      spots.push_back({seen, 1});
      person.push_back({{0.38 - 0.087, -double{seen.x}}, camera_height, seen, 0.0, 12.0});
    }
    lost.note_picture(1, {camera, {}, 12.0});
    lost.note(spots, 12.0);
    EXPECT_EQ(lost.are_among(person, {{}, camera, xtion_field, eye, 0.4}, 30.0, 13.0), !any_of_before);
  }
}

}  // namespace
}  // namespace safety_control_cloud
