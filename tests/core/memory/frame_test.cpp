// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/frame.hpp"

#include <gtest/gtest.h>

#include "lens.hpp"

namespace safety_control_cloud {
namespace {

Frame frame_of(const Lens& lens) { return {lens.width, lens.height, lens.rays()}; }

Spot spot_at(const Lens& lens, std::uint16_t row, std::uint16_t column) {
  Spot spot;
  spot.row = row, spot.column = column;
  spot.point = {static_cast<float>((column - lens.across) / lens.focal),
                static_cast<float>((row - lens.down) / lens.focal), 1.0f};
  return spot;
}

TEST(Frame, IsAnotherOneByItsSizeOrItsRaysAndNotByAFractionOfAPixel) {
  const Lens lens;
  const Frame frame = frame_of(lens);
  Lens shifted = lens, zoomed = lens, other_size = lens;
  shifted.across += 0.2, zoomed.focal *= 1.001;
  EXPECT_TRUE(frame == frame_of(shifted));
  EXPECT_TRUE(frame == frame_of(zoomed));
  shifted.across += 1.0, zoomed.focal *= 1.02, other_size.width += 1;
  EXPECT_FALSE(frame == frame_of(shifted));
  EXPECT_FALSE(frame == frame_of(zoomed));
  EXPECT_FALSE(frame == frame_of(other_size));
  EXPECT_FALSE((frame == Frame{lens.width, lens.height, {}}));
  EXPECT_TRUE((Frame{160, 120, {}} == Frame{160, 120, {}}));
}

TEST(Frame, ASpotLiesWhereItsPlaceIsSeen) {
  const Lens lens;
  for (const Lens& other : {lens.part(20, 10, 120, 100), lens.part(0, 0, 150, 110), Lens::of(75.0), lens.scaled(2.0)}) {
    Spot spot = spot_at(lens, 50, 90);
    place(spot, frame_of(lens), frame_of(other));
    EXPECT_TRUE(spot.is_shown());
    EXPECT_NEAR(spot.column, other.across + other.focal * double{spot.point.x}, 0.51);
    EXPECT_NEAR(spot.row, other.down + other.focal * double{spot.point.y}, 0.51);
    place(spot, frame_of(other), frame_of(lens));
    EXPECT_NEAR(spot.row, 50, 0.51);
    EXPECT_NEAR(spot.column, 90, 0.51);
  }
}

TEST(Frame, WhatAnotherPictureDoesNotShowIsShownAgainWhenItDoes) {
  const Lens lens, left = lens.part(0, 0, 100, 120), upper = lens.part(0, 0, 160, 80);
  Spot spot = spot_at(lens, 90, 110);
  place(spot, frame_of(lens), frame_of(left));
  EXPECT_FALSE(spot.column_shown);
  EXPECT_TRUE(spot.row_shown);
  EXPECT_LT(spot.column, left.width);
  place(spot, frame_of(left), frame_of(upper));
  EXPECT_TRUE(spot.column_shown);
  EXPECT_FALSE(spot.row_shown);
  place(spot, frame_of(upper), frame_of(lens));
  EXPECT_TRUE(spot.is_shown());
  EXPECT_EQ(spot.row, 90);
  EXPECT_EQ(spot.column, 110);
}

TEST(Frame, WhatWouldLeaveOnlyTheNewPictureComingNearerIsNotShown) {
  const Lens lens;
  Spot spot = spot_at(lens, 60, 110), at_the_edge = spot_at(lens, 60, 155);
  place(spot, frame_of(lens), frame_of(lens.part(0, 0, 115, 120)));
  EXPECT_FALSE(spot.is_shown());
  place(at_the_edge, frame_of(lens), frame_of(lens.scaled(2.0)));
  EXPECT_TRUE(at_the_edge.is_shown()) << "it would have left the old one too";
}

TEST(Frame, WhereNoRaysAreKnownBothPicturesShowTheSame) {
  Spot spot = spot_at(Lens{}, 60, 81);
  spot.point = {5.0f, 5.0f, 1.0f};
  place(spot, {160, 120, {}}, {80, 60, {}});
  EXPECT_TRUE(spot.is_shown());
  EXPECT_EQ(spot.row, 30);
  EXPECT_EQ(spot.column, 40);
}

TEST(Frame, OfAPictureWhoseRaysAreNotKnownAnyMoreNothingIsShown) {
  Spot spot = spot_at(Lens{}, 60, 81);
  place(spot, frame_of(Lens{}), {80, 60, {}});
  EXPECT_FALSE(spot.is_shown());
  place(spot, {80, 60, {}}, {40, 30, {}});
  EXPECT_FALSE(spot.is_shown());
  place(spot, {40, 30, {}}, frame_of(Lens{}));
  EXPECT_TRUE(spot.is_shown());
  EXPECT_EQ(spot.column, 81);
}

TEST(Frame, SizesDifferByTheAngle) {
  const Lens lens;
  EXPECT_NEAR(share_of_angle(frame_of(lens.part(40, 0, 80, 120)), frame_of(lens)), 0.25, 1e-9);
  EXPECT_NEAR(share_of_angle(frame_of(lens.scaled(2.0)), frame_of(lens)), 1.0, 1e-9) << "more pixels, the same angle";
  EXPECT_EQ(share_of_angle({160, 120, {}}, frame_of(lens)), 1.0);
}

}  // namespace
}  // namespace safety_control_cloud
