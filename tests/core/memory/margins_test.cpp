// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/margins.hpp"

#include <gtest/gtest.h>

#include <random>

#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::size_t width = 64, height = 48;

/// A wall, seen but for so many columns and rows at the sides, in which so large a share returns all the same.
struct Camera {
  std::size_t left, top, right, bottom;
  double stray = 0.0, dropped = 0.0;

  Framing after(std::size_t pictures, Margins& margins, std::mt19937& random) const {
    std::uniform_real_distribution<double> any(0.0, 1.0);
    Framing framing;
    for (std::size_t i = 0; i < pictures; ++i) {
      std::vector<Xyz> points;
      for (std::size_t row = 0; row < height; ++row) {
        for (std::size_t column = 0; column < width; ++column) {
          const bool inside = row >= top && row + bottom < height && column >= left && column + right < width;
          const bool returns = any(random) < (inside ? 1.0 - dropped : stray);
          points.push_back(returns ? Xyz{0.0f, 0.0f, 2.0f} : Xyz{nan, nan, nan});
        }
      }
      CloudView view = view_of(points);
      view.width = width, view.height = height, view.row_step = width * sizeof(Xyz);
      framing = margins.note(Pixels(view, 0.0f));
    }
    return framing;
  }
  Framing after(std::size_t pictures) const {
    Margins margins;
    std::mt19937 random(5);
    return after(pictures, margins, random);
  }
};

void expect_same(const Framing& framing, const Camera& camera) {
  EXPECT_EQ(framing.left, camera.left);
  EXPECT_EQ(framing.top, camera.top);
  EXPECT_EQ(framing.right, camera.right);
  EXPECT_EQ(framing.bottom, camera.bottom);
}

TEST(Margins, AreWhatNeverReturnsAtThePicturesSides) {
  expect_same(Camera{0, 0, 0, 0}.after(200), {0, 0, 0, 0});
  expect_same(Camera{3, 1, 0, 5}.after(200), {3, 1, 0, 5});
  expect_same(Camera{8, 0, 2, 6}.after(200), {8, 0, 2, 6});
  EXPECT_EQ(Camera{}.after(1).middle_row, 24.0);
  EXPECT_EQ(Camera{}.after(1).middle_column, 32.0);
}

TEST(Margins, ThereAreNoneBeforeEnoughHasBeenSeen) { expect_same(Camera{3, 1, 2, 5}.after(63), {0, 0, 0, 0}); }

TEST(Margins, StrayReturnsInThemAndPixelsMissingBesideThemChangeNothing) {
  expect_same(Camera{3, 1, 2, 5, 0.02, 0.3}.after(200), {3, 1, 2, 5});
}

TEST(Margins, TakeAnEighthAtMost) { expect_same(Camera{20, 20, 20, 20}.after(200), {8, 6, 8, 6}); }

/// A thing that is too near to return, or a hall that is deeper than the range.
TEST(Margins, WhatHasReturnedIsNoneWhateverHidesIt) {
  Margins margins;
  std::mt19937 random(5);
  Camera{0, 0, 0, 0}.after(80, margins, random);
  expect_same(Camera{8, 6, 8, 6}.after(500, margins, random), {0, 0, 0, 0});
}

TEST(Margins, OfAnotherPictureAreLearnedAnew) {
  Margins margins;
  std::mt19937 random(5);
  EXPECT_EQ((Camera{8, 0, 0, 0}.after(200, margins, random).left), std::size_t{8});
  const std::vector<Xyz> points(16 * 16, Xyz{0.0f, 0.0f, 2.0f});
  CloudView view = view_of(points);
  view.width = view.height = 16, view.row_step = 16 * sizeof(Xyz);
  EXPECT_EQ(margins.note(Pixels(view, 0.0f)).left, std::size_t{0});
}

/// Its way out of the picture leads through a margin.
TEST(Margins, WhatHungBesideOneAndIsTakenAwayIsNotLostForEver) {
  const Board wall = {2.2f, -3.0f, 3.0f, -3.0f, floor_y};
  for (const std::size_t margin : {0, 2, 9}) {
    Robot robot;
    const auto sees = [&](const std::vector<Board>& boards) {
      Scene scene(boards);
      for (std::size_t row = 0; row < Scene::height; ++row)
        for (std::size_t i = 0; i < margin; ++i) scene.set(row, Scene::width - 1 - i, nan);
      return robot.sees(scene);
    };
    for (int i = 0; i < 70; ++i) sees({wall});
    const auto board_at = [](float z) { return Board{z, 0.1f, 0.26f, -0.15f, 0.05f}; };
    for (float z = 0.8f; z > 0.36f; z -= 0.02f) sees({wall, board_at(z)});
    for (int i = 0; i < 10; ++i) ASSERT_EQ(sees({wall, board_at(0.36f)}).speed, 0.0) << margin;
    Decision decision;
    for (int i = 0; i < 30; ++i) decision = sees({wall});
    EXPECT_EQ(decision.speed, 0.2) << margin << ": " << decision.reason;
  }
}

}  // namespace
}  // namespace safety_control_cloud
