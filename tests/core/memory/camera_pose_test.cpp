// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/camera_pose.hpp"

#include <gtest/gtest.h>

#include "../../../safety_control_cloud/core/memory/camera_height.hpp"

namespace safety_control_cloud {
namespace {

/// Turned about the vertical, tilted about its own right, and there.
Outlook looking(double turned, double tilted, float x, float y, float z) {
  const auto c = static_cast<float>(std::cos(turned)), s = static_cast<float>(std::sin(turned));
  const auto d = static_cast<float>(std::cos(tilted)), t = static_cast<float>(std::sin(tilted));
  Placement place;
  place.rows = {{{c, s * t, s * d, x}, {0, d, -t, y}, {-s, c * t, c * d, z}}};
  return {Corridor(), place};
}

void expect_same(const CameraPose::Vector& one, const CameraPose::Vector& other) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(one[i], other[i], 1e-5);
}

const CameraPose aside = camera_pose_of(looking(0.7, 0.3, 0.1f, -0.4f, 0.2f));

TEST(CameraPose, PlacesWhatItSeesAsTheOutlookDoes) {
  const Point there = looking(0.7, 0.3, 0.1f, -0.4f, 0.2f).placed(0.1f, -0.2f, 0.5f);
  const Point placed = aside.placed({0.1f, -0.2f, 0.5f});
  expect_same({placed.x, placed.y, placed.z}, {there.x, there.y, there.z});
  expect_same(aside.into(aside.out_of({0.3f, 0.5f, 0.7f})), {0.3f, 0.5f, 0.7f});
}

TEST(CameraPose, InTheAxesOfAnotherFrameIsThereAsSeenFromTheCameraThatHasNotMoved) {
  const CameraPose before = camera_pose_of(looking(-0.4, 0.1, 0.0f, -0.3f, 0.0f)), now;
  const CameraPose moved = in_axes_of(now, before, aside);
  const Point thing(0.1f, -0.2f, 0.5f);  // as the one that looks aside sees it
  const Point in_old_axes = aside.placed(thing), in_new_axes = moved.placed(thing);
  const auto from_before =
      before.into({in_old_axes.x - before.at[0], in_old_axes.y - before.at[1], in_old_axes.z - before.at[2]});
  expect_same(from_before, {in_new_axes.x, in_new_axes.y, in_new_axes.z});
  const CameraPose itself = in_axes_of(aside, before, before);
  expect_same(itself.ahead, aside.ahead);
  expect_same(itself.right, aside.right);
  expect_same(itself.at, aside.at);
}

TEST(CameraPose, TurnsByAnglesAndByWaysThatAreMoreThanNoise) {
  CameraPose away = aside;
  away.at[1] += 0.009f;
  EXPECT_TRUE(show_the_same(aside, away));
  EXPECT_LT(turning_between(aside, away), still);
  away.at[1] += 0.002f;
  EXPECT_FALSE(show_the_same(aside, away));
  EXPECT_GT(turning_between(aside, away), still);
  const CameraPose turned = camera_pose_of(looking(0.71, 0.3, 0.1f, -0.4f, 0.2f));
  EXPECT_NEAR(turning_between(aside, turned), 0.0096f, 0.0006f);
  EXPECT_TRUE(show_the_same(aside, turned));
  EXPECT_FALSE(show_the_same(aside, camera_pose_of(looking(0.73, 0.3, 0.1f, -0.4f, 0.2f))));
}

TEST(CameraHeight, WasHigherByWhatItWasInTheLatestTenPictures) {
  CameraHeight height;
  EXPECT_EQ(height.note(0.3f), 0.0f);
  EXPECT_NEAR(height.note(0.29f), 0.01f, 1e-6f);
  EXPECT_EQ(height.note(0.5f), 0.0f);
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(height.note(0.2f), 0.3f, 1e-6f) << i;
  EXPECT_EQ(height.note(0.2f), 0.0f);
}

}  // namespace
}  // namespace safety_control_cloud
