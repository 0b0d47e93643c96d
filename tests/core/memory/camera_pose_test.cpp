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

void expect_same(const std::array<float, 3>& one, const std::array<float, 3>& other) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(one[i], other[i], 1e-5);
}

void expect_same(const Point& one, const Point& other) {
  expect_same(std::array{one.x, one.y, one.z}, std::array{other.x, other.y, other.z});
}

const CameraPose aside = camera_pose_of(looking(0.7, 0.3, 0.1f, -0.4f, 0.2f));

TEST(CameraPose, PlacesWhatItSeesAsTheOutlookDoes) {
  const Outlook outlook = looking(0.7, 0.3, 0.1f, -0.4f, 0.2f);
  expect_same(aside(0.1f, -0.2f, 0.5f), outlook.placed(0.1f, -0.2f, 0.5f));
  expect_same(aside.seen(aside(0.3f, 0.5f, 0.7f)), Point(0.3f, 0.5f, 0.7f));
}

TEST(CameraPose, InTheAxesOfAnotherFrameIsThereAsSeenFromTheCameraThatHasNotMoved) {
  const CameraPose before = camera_pose_of(looking(-0.4, 0.1, 0.0f, -0.3f, 0.0f)), now;
  const CameraPose moved = in_axes_of(now, before, aside);
  // As the one that looks aside sees it.
  expect_same(before.seen(aside(0.1f, -0.2f, 0.5f)), moved(0.1f, -0.2f, 0.5f));
  const CameraPose itself = in_axes_of(aside, before, before);
  expect_same(ahead_of(itself), ahead_of(aside));
  expect_same(right_of(itself), right_of(aside));
  expect_same(place_of(itself), place_of(aside));
}

TEST(CameraPose, TurnsByAnglesAndByWaysThatAreMoreThanNoise) {
  CameraPose away = aside;
  away.rows[1][3] += 0.009f;
  EXPECT_TRUE(show_the_same(aside, away));
  EXPECT_LT(turning_between(aside, away), still);
  away.rows[1][3] += 0.002f;
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
