// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/look/outlook.hpp"

#include <gtest/gtest.h>

#include "../../../safety_control_cloud/core/look/settings.hpp"

namespace safety_control_cloud {
namespace {

Placement turned_and_moved() {
  Placement placement;  // a quarter turn about y, then 1, 2 and 3 m
  placement.rows = {{{0, 0, 1, 1}, {0, 1, 0, 2}, {-1, 0, 0, 3}}};
  return placement;
}

TEST(Outlook, WhatIsPlacedIsSeenFromTheCameraWhereItWas) {
  const Outlook outlook(Corridor{}, turned_and_moved());
  const Point placed = outlook.placed(0.5f, -0.25f, 4.0f), back = outlook.seen_from_camera(placed);
  EXPECT_FLOAT_EQ(placed.x, 5.0f);
  EXPECT_FLOAT_EQ(placed.y, 1.75f);
  EXPECT_FLOAT_EQ(placed.z, 2.5f);
  EXPECT_FLOAT_EQ(back.x, 0.5f);
  EXPECT_FLOAT_EQ(back.y, -0.25f);
  EXPECT_FLOAT_EQ(back.z, 4.0f);
  EXPECT_EQ(outlook.camera().z, 3.0f);
}

TEST(Outlook, InItsOwnFrameTheCameraIsTheOrigin) {
  const Outlook outlook;
  EXPECT_EQ(outlook.placed(1.0f, 2.0f, 3.0f).y, 2.0f);
  EXPECT_EQ(outlook.seen_from_camera(Point(1.0f, 2.0f, 3.0f)).y, 2.0f);
  EXPECT_EQ(outlook.camera().z, 0.0f);
}

TEST(Outlook, FrameOfTheSettingsAndPlaceOfTheCameraBelongTogether) {
  LookSettings own, framed;
  framed.target_frame = "base_footprint";
  EXPECT_FALSE(std::get<Outlook>(outlook_of(own, OpticalFrame{})).placement);
  EXPECT_TRUE(std::get<Outlook>(outlook_of(framed, turned_and_moved())).placement);
  EXPECT_TRUE(std::holds_alternative<NoTransform>(outlook_of(own, turned_and_moved())));
  EXPECT_TRUE(std::holds_alternative<NoTransform>(outlook_of(framed, OpticalFrame{})));
  EXPECT_EQ(std::get<NoTransform>(outlook_of(framed, NoTransform{"no tf"})).reason, "no tf");
}

TEST(Outlook, MinusInfinityOfADepthImageMeansWhatTheSettingsSay) {
  LookSettings settings;
  settings.depth_minus_inf = MinusInf::TooClose;
  EXPECT_EQ(std::get<DepthView>(view_in(Reading(DepthView{}), settings)).minus_inf, MinusInf::TooClose);
  settings.depth_minus_inf = MinusInf::Nothing;
  EXPECT_EQ(std::get<DepthView>(view_in(Reading(DepthView{}), settings)).minus_inf, MinusInf::Nothing);
}

}  // namespace
}  // namespace safety_control_cloud
