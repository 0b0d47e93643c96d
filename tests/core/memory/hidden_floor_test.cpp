// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/hidden_floor.hpp"

#include <gtest/gtest.h>

#include "lens.hpp"

namespace safety_control_cloud {
namespace {

const Lens lens;
const RayLines rays = lens.rays();
constexpr float near = 0.4f;  // [m]
const std::vector<Span> middle{{0.45, 0.55}}, nowhere;
constexpr std::size_t from = 72, to = 87;  // columns

/// Of a camera that looks so far up [rad].
Gaze looking(double up = 0.0, const RayLines& lines = rays) {
  const auto c = static_cast<float>(std::cos(up)), s = static_cast<float>(std::sin(up));
  Placement place;
  place.rows = {{{1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0}}};
  return {{Corridor(), place}, lines};
}

/// The floor, but for the columns in which something hides it.
struct Picture {
  std::vector<Xyz> points = lens.points({});
  CloudView view{};

  Pixels pixels(bool hidden = true) {
    for (std::size_t row = 60; row < lens.height; ++row)
      for (std::size_t column = from; column <= to && hidden; ++column)
        points[row * lens.width + column] = {NAN, NAN, NAN};
    view = lens.view_of_rows(points);
    return Pixels(view, 0.0f);
  }
};

/// As it shows one picture of a camera that looks ahead.
FloorStrip strip(Picture picture, bool hidden = true) {
  NearGround ground;
  ground.look_at(picture.pixels(hidden), looking().outlook, 0.75f, 0);
  FloorStrip floor;
  floor.survey(ground);
  return floor;
}

/// After two pictures, of which the second shows that the camera rests.
HiddenFloor noted(const Gaze& gaze = looking()) {
  Picture picture;
  HiddenFloor hidden;
  for (int i = 0; i < 2; ++i) hidden.note(strip(picture), middle, {}, picture.pixels(), gaze, near);
  return hidden;
}

TEST(HiddenFloor, WhatHidesItLiesInTheCorridorOnTheRaysThatItHides) {
  const auto spots = noted().spots();
  ASSERT_FALSE(spots.empty());
  for (const Spot& spot : spots) {
    EXPECT_TRUE(spot.column >= from && spot.column <= to) << spot.column;
    EXPECT_TRUE(spot.row < 119) << "at the picture's border: another one would say nothing of it";
    EXPECT_TRUE(Corridor().holds(spot.place()));
    EXPECT_LE(spot.point.z, near);
    EXPECT_NEAR(spot.point.x / spot.point.z, (spot.column - lens.across) / lens.focal, 1e-5);
    EXPECT_NEAR(spot.point.y / spot.point.z, (spot.row - lens.down) / lens.focal, 1e-5);
  }
}

TEST(HiddenFloor, ItMayBeRightBeforeTheCamerasBlindRangeOrMuchNearer) {
  float nearest = near, farthest = 0.0f;
  const HiddenFloor hidden = noted();
  for (const Spot& spot : hidden.spots()) {
    nearest = std::min(nearest, spot.point.z);
    farthest = std::max(farthest, spot.point.z);
  }
  EXPECT_LT(nearest, 0.7f * farthest);
}

TEST(HiddenFloor, NothingIsKnownOfWhatIsNotCoveredOrReturnsOrIfNobodyKnowsWhichWayThePixelsLook) {
  Picture picture;
  HiddenFloor hidden;
  for (int i = 0; i < 2; ++i) hidden.note(strip(picture), nowhere, {}, picture.pixels(), looking(), near);
  EXPECT_TRUE(hidden.spots().empty());
  for (int i = 0; i < 2; ++i) hidden.note(strip(picture), {{0.1, 0.2}}, {}, picture.pixels(), looking(), near);
  EXPECT_TRUE(hidden.spots().empty()) << "the floor returns there";
  EXPECT_TRUE(noted(looking(0.0, {})).spots().empty());
}

TEST(HiddenFloor, WhatStandsThereAndIsLostExplainsIt) {
  Picture picture;
  Spot spot;
  spot.row = 60, spot.column = 79, spot.stands = true, spot.camera = looking().camera;
  Remembered post;
  post.lost.assign(3, spot);
  post.lost[1].column = 72, post.lost[2].column = 88;
  const auto spans = hidden_by({post}, picture.pixels(), looking().camera);
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_TRUE(spans[0].from < 0.45 && spans[0].to > 0.55);
  HiddenFloor hidden;
  for (int i = 0; i < 2; ++i) hidden.note(strip(picture), middle, {post}, picture.pixels(), looking(), near);
  EXPECT_TRUE(hidden.spots().empty());
  EXPECT_TRUE(hidden_by({post}, picture.pixels(), looking(0.1).camera).empty()) << "as another camera saw it";
  for (Spot& hanging : post.lost) hanging.stands = false;
  EXPECT_TRUE(hidden_by({post}, picture.pixels(), looking().camera).empty()) << "it may hang above what hides it";
}

TEST(HiddenFloor, ItIsLeftBehindOnceTheCameraLooksElsewhere) {
  HiddenFloor hidden = noted();
  const std::size_t spots = hidden.spots().size();
  EXPECT_TRUE(hidden.left_behind(looking(0.01).camera).empty()) << "by less than 1 degree";
  EXPECT_EQ(hidden.left_behind(looking(0.05).camera).size(), spots);
  EXPECT_TRUE(hidden.spots().empty());
  EXPECT_TRUE(hidden.left_behind(looking(0.1).camera).empty()) << "once";
}

TEST(HiddenFloor, OnceTheCameraHasLookedElsewhereOnlyWhatWasSeenToBeHiddenCounts) {
  HiddenFloor hidden = noted();
  Picture dark, picture;
  const Gaze there = looking(0.1);
  EXPECT_FALSE(hidden.left_behind(there.camera).empty());
  for (int i = 0; i < 4; ++i) hidden.note(strip(dark), middle, {}, dark.pixels(), there, near);
  EXPECT_TRUE(hidden.spots().empty()) << "it may be a carpet";
  hidden.note(strip(picture, false), nowhere, {}, picture.pixels(false), there, near);
  hidden.note(strip(dark), middle, {}, dark.pixels(), there, near);
  EXPECT_FALSE(hidden.spots().empty()) << "it has come";
}

TEST(HiddenFloor, ItIsLeftBehindThoughTFIsAPictureLate) {
  HiddenFloor hidden = noted();
  Picture past, picture;
  hidden.note(strip(picture), middle, {}, past.pixels(false), looking(), near);
  EXPECT_FALSE(hidden.left_behind(looking(0.1).camera).empty()) << "the camera had turned by the latest one";
}

TEST(HiddenFloor, ItIsLeftBehindByACameraThatTurnsSlowly) {
  HiddenFloor hidden = noted();
  Picture picture;
  std::size_t left = 0;
  for (double up = 0.0; up < 0.03; up += 0.004) {
    const Gaze gaze = looking(up);
    left += hidden.left_behind(gaze.camera).size();
    hidden.note(strip(picture), middle, {}, picture.pixels(), gaze, near);
  }
  EXPECT_GT(left, 0U);
}

TEST(HiddenFloor, ItHasGoneOnceThreePicturesOfACameraThatRestsShowTheFloor) {
  HiddenFloor hidden = noted();
  Picture picture;
  for (int i = 0; i < 2; ++i) hidden.note(strip(picture, false), nowhere, {}, picture.pixels(false), looking(), near);
  EXPECT_FALSE(hidden.spots().empty());
  EXPECT_FALSE(hidden.may_be_there()) << "of a camera that never turned, one picture is enough";
  hidden.note(strip(picture, false), nowhere, {}, picture.pixels(false), looking(0.008), near);
  EXPECT_TRUE(hidden.may_be_there()) << "it turns";
  hidden.note(strip(picture, false), nowhere, {}, picture.pixels(false), looking(0.008), near);
  EXPECT_TRUE(hidden.spots().empty());
  EXPECT_FALSE(hidden.may_be_there());
}

}  // namespace
}  // namespace safety_control_cloud
