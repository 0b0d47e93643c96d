// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/turned.hpp"

#include <gtest/gtest.h>

#include "../../../safety_control_cloud/core/look/look.hpp"
#include "../../../safety_control_cloud/core/memory/near_loss.hpp"
#include "../../../safety_control_cloud/core/memory/near_things.hpp"
#include "lens.hpp"

namespace safety_control_cloud {
namespace {

const Lens lens;
const RayLines rays = lens.rays();
constexpr float wall = 2.0f;  // [m]

/// Of a camera that looks so far [rad] to the right, and is a little before what it turns around.
Outlook looking(double angle) {
  constexpr float before = 0.05f;
  const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  Placement place;
  place.rows = {{{c, 0, s, before * s}, {0, 1, 0, 0}, {-s, 0, c, before * c}}};
  return {Corridor(), place};
}

/// What is seen at 0.45 m, so far to the right and down [m] of a camera that looks straight ahead.
Spot seen_ahead(float right = 0.0f, float down = 0.0f) {
  Spot spot;
  spot.point = {right, down, 0.45f};
  spot.camera = camera_pose_of(looking(0.0));
  spot.company = 9, spot.share = 1.0f;
  return spot;
}

/// A wall, but for a rectangle of pixels in which something else is seen.
struct Picture {
  std::vector<Xyz> points = std::vector<Xyz>(lens.width * lens.height, Xyz{0.0f, 0.0f, wall});
  CloudView view{};

  Pixels with(std::size_t row, std::size_t column, std::size_t around, float z) {
    for (std::size_t i = row - around; i <= row + around; ++i)
      for (std::size_t j = column - around; j <= column + around; ++j) points[i * lens.width + j].z = z;
    return pixels();
  }
  Pixels pixels() {
    view = lens.view_of_rows(points);
    return Pixels(view, 0.0f);
  }
};

TEST(Turned, ASpotLiesWhereThePlaceIsSeenFromWhereTheCameraIsByNow) {
  Picture picture;
  const Pixels pixels = picture.pixels();
  for (const double angle : {-0.3, -0.1, 0.2, 0.4}) {
    const auto turned = turned_spot(seen_ahead(0.02f, 0.05f), {looking(angle), rays}, pixels);
    ASSERT_TRUE(turned) << angle;
    const Point seen = looking(angle).seen_from_camera(placed({0.02f, 0.05f, 0.45f}, looking(0.0)));
    EXPECT_EQ(turned->spot.column, std::lround(lens.across + lens.focal * seen.x / seen.z)) << angle;
    EXPECT_EQ(turned->spot.row, std::lround(lens.down + lens.focal * seen.y / seen.z)) << angle;
    EXPECT_EQ(turned->spot.point.z, seen.z) << angle;
  }
}

TEST(Turned, NothingIsSaidOfWhatLiesBesideThePictureOrIfNobodyKnowsWhichWayThePixelsLook) {
  Picture picture;
  const Pixels pixels = picture.pixels();
  EXPECT_FALSE(turned_spot(seen_ahead(), {looking(0.7), rays}, pixels)) << "beside it";
  EXPECT_FALSE(turned_spot(seen_ahead(), {looking(3.0), rays}, pixels)) << "behind the camera";
  EXPECT_FALSE(turned_spot(seen_ahead(), {looking(0.2), {}}, pixels)) << "no rays";
  const auto at_border = turned_spot(seen_ahead(), {looking(0.46), rays}, pixels);
  ASSERT_TRUE(at_border);
  EXPECT_FALSE(at_border->is_whole);
}

TEST(Turned, AboveAndBelowThePictureArePlacesBesideItToo) {
  Picture picture;
  const Pixels pixels = picture.pixels();
  const Gaze aside({looking(0.7), rays});
  EXPECT_EQ(above_or_below(seen_ahead(), aside, pixels), 0.0);
  EXPECT_GT(above_or_below(seen_ahead(0.0f, 0.4f), aside, pixels).value(), 0.1);
  EXPECT_GT(above_or_below(seen_ahead(0.0f, -0.4f), aside, pixels).value(), 0.1);
  EXPECT_FALSE(above_or_below(seen_ahead(), {looking(3.0), rays}, pixels)) << "behind the camera";
}

/// What ends with the picture counts as standing.
TEST(Turned, WhatStoodInATiltedPictureIsNotKnownToStand) {
  Picture picture;
  const Pixels pixels = picture.pixels();
  Spot spot = seen_ahead();
  spot.stands = true;
  EXPECT_TRUE(turned_spot(spot, {looking(0.2), rays}, pixels)->spot.stands);
  spot.camera.rows[1][2] = -0.1f, spot.camera.rows[2][2] = 0.995f;
  EXPECT_FALSE(turned_spot(spot, {looking(0.2), rays}, pixels)->spot.stands);
}

TEST(Turned, ItHasGoneWhereAllOfItsPlacesShowWhatIsBehind) {
  const Gaze right({looking(0.2), rays});
  Picture free;
  const Pixels pixels = free.pixels();
  const auto turned = turned_spot(seen_ahead(), right, pixels);
  ASSERT_TRUE(turned);
  EXPECT_EQ(evidence_of(*turned, pixels), Evidence::Past);
  EXPECT_FALSE(leaves_a_hole(*turned, pixels));
  for (const auto& place : {turned->places.front(), turned->places.back()}) {
    Picture hole, nearer;
    const Pixels with_hole = hole.with(place.row, place.column, 3, nan);
    EXPECT_EQ(evidence_of(*turned, with_hole), Evidence::Nothing);
    EXPECT_TRUE(leaves_a_hole(*turned, with_hole));
    EXPECT_NE(evidence_of(*turned, nearer.with(place.row, place.column, 1, 0.45f)), Evidence::Past);
  }
}

/// 0.05 rad are 7 pixels.
TEST(Turned, TheFasterTheCameraTurnedAsItWasSeenTheFartherAsideItMayLie) {
  Picture picture;
  const Pixels empty = picture.pixels();
  const auto says = [&](float turning, std::size_t aside) {
    Spot spot = seen_ahead();
    spot.turning = turning;
    const auto turned = turned_spot(spot, {looking(0.2), rays}, empty);
    Picture hole;
    return evidence_of(*turned, hole.with(turned->spot.row, turned->spot.column + aside, 2, nan));
  };
  EXPECT_EQ(says(0.0f, 7), Evidence::Past);
  EXPECT_EQ(says(0.05f, 7), Evidence::Nothing);
  EXPECT_EQ(says(0.05f, 14), Evidence::Past);
}

TEST(Turned, ItIsThereWhereAllOfItsPlacesShowIt) {
  Picture all, part;
  const Pixels empty = Picture(all).pixels();
  const auto turned = turned_spot(seen_ahead(), {looking(0.2), rays}, empty);
  const float z = turned->spot.point.z;
  EXPECT_TRUE(is_there(*turned, all.with(turned->spot.row, turned->spot.column, 12, z)));
  EXPECT_FALSE(is_there(*turned, part.with(turned->spot.row, turned->spot.column, 1, z)));
}

/// Its place is told in the corridor's axes, which turn with that.
TEST(Turned, WhatIsLostLiesWhereItDidHoweverTheCorridorTurns) {
  NearLoss memory{NearLossLimits()};
  double now = 0.0;
  const auto loss_in = [&](const Scene& scene, double facing) {
    Placement place;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<float, 3> axes{};
      axes[i] = 1.0f;
      const auto [right, down, forward] = in_turned_axes(axes, facing);
      place.rows[0][i] = right, place.rows[1][i] = down, place.rows[2][i] = forward;
    }
    const Outlook outlook(Corridor(), place);
    return memory.judge(scene.view(), look(scene.view(), outlook, Crop::Skip, Rows::Apart), outlook, now += 0.05, 0.05);
  };
  const auto with_board = [](float z) {
    return Scene({{z, -0.05f, 0.05f, -0.2f, 0.05f}, {2.0f, -9.0f, 9.0f, -9.0f, 9.0f}});
  };
  for (const float z : {0.6f, 0.5f, 0.45f}) loss_in(with_board(z), 0.0);
  ASSERT_TRUE(loss_in(with_board(0.36f), 0.0));
  memory.turn_corridor(1.0);
  EXPECT_FALSE(loss_in(with_board(0.36f), 1.0)) << "it lies beside the corridor";
  memory.turn_corridor(-1.0);
  EXPECT_TRUE(loss_in(with_board(0.36f), 0.0)) << "it lies in it again";
  memory.turn_corridor(1.0);
  for (int i = 0; i < 10; ++i) loss_in(Scene({{2.0f, -9.0f, 9.0f, -9.0f, 9.0f}}), 1.0);
  memory.turn_corridor(-1.0);
  EXPECT_FALSE(loss_in(Scene({{2.0f, -9.0f, 9.0f, -9.0f, 9.0f}}), 0.0)) << "it was seen to go";
}

}  // namespace
}  // namespace safety_control_cloud
