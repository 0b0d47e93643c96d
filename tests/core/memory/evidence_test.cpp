// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/evidence.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "../input/cloud_builder.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::size_t size = 9;  ///< pixels across and down

CloudView picture_of(const std::vector<Xyz>& points, std::size_t width, std::size_t height) {
  CloudView view = view_of(points);
  view.width = width, view.height = height, view.row_step = width * sizeof(Xyz);
  return view;
}

/// What a picture says of a thing at 0.4 m in its middle, of which five of nine pixels returned; those return these.
Evidence said(const std::vector<float>& ranges) {
  std::vector<Xyz> points(size * size, Xyz{nan, nan, nan});
  const std::size_t middle = size / 2;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    points[(middle - 1 + i / 3) * size + middle - 1 + i % 3] = {0.0f, 0.0f, ranges[i]};
  }
  const CloudView view = picture_of(points, size, size);
  Spot spot;
  spot.row = spot.column = middle;
  spot.point = {0.0f, 0.0f, 0.4f};
  spot.company = 5;
  return evidence_of(spot, Pixels(view, 0.0f));
}

TEST(Evidence, OnlyReturnsBehindThatAgreeSayThatAThingHasGone) {
  EXPECT_EQ(said({2.0f, 2.05f, 2.1f, 2.0f, 2.05f}), Evidence::Past);
  EXPECT_EQ(said({2.0f, 2.05f, 2.1f, 2.0f}), Evidence::Past) << "as many as nearly returned";
  EXPECT_EQ(said({2.0f, 2.05f, 2.1f}), Evidence::Nothing) << "too few";
  EXPECT_EQ(said({2.0f, 1.0f, 3.0f, 4.5f, 1.4f}), Evidence::Nothing) << "strays, each at another range";
  EXPECT_EQ(said({2.0f}), Evidence::Nothing);
  EXPECT_EQ(said({}), Evidence::Nothing);
}

TEST(Evidence, ReturnsAtItsRangeOrBeforeItSayThatItMayBeThere) {
  EXPECT_EQ(said({0.4f, 0.41f, 0.39f}), Evidence::There);
  EXPECT_EQ(said({0.2f, 0.21f, 0.2f}), Evidence::Hidden);
  EXPECT_EQ(said({0.4f, 0.2f, 0.2f, 2.0f, 2.0f}), Evidence::There);
}

/// A depth image tells its middle, a cloud shows it but for rounding; a fuzzer found a picture of which one drove on.
TEST(Evidence, ARowAtTheVeryLimitLeavesThePictureHoweverItsMiddleIsRounded) {
  const std::vector<Xyz> points(size * size, Xyz{0.0f, 0.0f, 2.0f});
  const CloudView view = picture_of(points, size, size);
  Spot at_limit, below;
  at_limit.row = 4, below.row = 5;
  for (const double middle : {20.0 - 1e-5, 20.0, 20.0 + 1e-5}) {
    Pixels picture(view, 0.0f);
    picture.frame({0, 0, 0, 0, middle, 20.0});
    EXPECT_TRUE(leaves_at_the_top(at_limit, picture)) << middle;
    EXPECT_FALSE(leaves_at_the_top(below, picture)) << middle;
  }
}

/// A wall at 2 m, seen by a camera of so many pixels.
struct Wall {
  std::size_t width, height;
  std::vector<Xyz> points;

  Wall(std::size_t columns, std::size_t rows) : width(columns), height(rows), points(columns * rows, {0, 0, 2.0f}) {}
  void blank(std::size_t row, std::size_t column) { points[row * width + column] = {nan, nan, nan}; }
  /// Of a thing at 0.4 m.
  Evidence said_of(std::size_t row, std::size_t column, const Framing* framing = nullptr) const {
    const CloudView view = picture_of(points, width, height);
    Pixels picture(view, 0.0f);
    if (framing) picture.frame(*framing);
    Spot spot;
    spot.row = static_cast<std::uint16_t>(row), spot.column = static_cast<std::uint16_t>(column);
    spot.point = {0.0f, 0.0f, 0.4f};
    spot.company = 9;
    return evidence_of(spot, picture);
  }
};

/// What was seen there has moved aside by a pixel, or the camera has turned by one.
TEST(Evidence, BesideAnEdgeOfItThatIsStillThereItIsSeenPast) {
  EXPECT_EQ(said({0.4f, 2.0f, 2.05f, 0.4f, 2.1f}), Evidence::Past);
  EXPECT_EQ(said({0.4f, 2.0f, 2.05f, 2.1f}), Evidence::Past) << "as many as nearly returned, in all";
  EXPECT_EQ(said({0.4f, 0.4f, 2.0f, 2.05f}), Evidence::Nothing) << "fewer than half of them behind it";
  EXPECT_EQ(said({0.4f, 2.0f, 4.0f, 0.4f, 3.0f}), Evidence::Nothing) << "strays";
  EXPECT_EQ(said({0.2f, 2.0f, 2.05f, 2.1f}), Evidence::Nothing) << "it may be what has come before it";
  Wall wall(size, size);
  for (std::size_t row = 0; row < size; ++row) wall.points[row * size + 5] = {0.0f, 0.0f, 0.4f};
  EXPECT_EQ(wall.said_of(4, 4), Evidence::Past);
  for (std::size_t row = 3; row <= 5; ++row) wall.blank(row, 4);
  EXPECT_EQ(wall.said_of(4, 4), Evidence::Nothing) << "a hole as wide as a pixel";
}

TEST(Evidence, AHoleOnTheWayOutwardMayBeTheThingItself) {
  Wall wall(160, 120);
  EXPECT_EQ(wall.said_of(60, 120), Evidence::Past);
  for (std::size_t row = 50; row < 70; ++row) wall.blank(row, 126);
  EXPECT_EQ(wall.said_of(60, 120), Evidence::Nothing);
  EXPECT_EQ(wall.said_of(60, 40), Evidence::Past) << "its way leads to the other side";
}

TEST(Evidence, PixelsThatAreMissingByChanceAreNoHoleHoweverManyThereAre) {
  std::mt19937 random(3);
  std::bernoulli_distribution missing(0.3);
  int past = 0;
  for (int i = 0; i < 20; ++i) {
    Wall wall(640, 480);
    for (std::size_t row = 200; row < 280; ++row)
      for (std::size_t column = 400; column < 640; ++column)
        if (missing(random) && (row < 239 || row > 241 || column < 479 || column > 481)) wall.blank(row, column);
    past += wall.said_of(240, 480) == Evidence::Past;
  }
  EXPECT_GE(past, 18);
}

TEST(Evidence, TheWayOutwardLeadsAwayFromWhatLooksStraightAhead) {
  Wall wall(160, 120);
  for (std::size_t column = 60; column < 100; ++column) wall.blank(46, column);
  EXPECT_EQ(wall.said_of(40, 80), Evidence::Past) << "upward, from the middle";
  Framing framing;
  framing.middle_row = 10.0, framing.middle_column = 80.0;
  EXPECT_EQ(wall.said_of(40, 80, &framing), Evidence::Nothing);
}

/// As a cloud has it by its returns, and a depth image by its camera.
TEST(Evidence, AMiddleThatDiffersByRoundingAloneIsTheSame) {
  const std::vector<Xyz> points(size * size, Xyz{0.0f, 0.0f, 2.0f});
  const auto middle_by = [&](double off) {
    Pixels picture(picture_of(points, size, size), 0.0f);
    const RayLine line{-(4.0 + off) / 46.2, 1.0 / 46.2};
    picture.look_along({line, line});
    return std::pair(picture.framing().middle_row, picture.framing().middle_column);
  };
  for (const double off : {1e-6, -1e-6, 3e-4}) EXPECT_EQ(middle_by(off), middle_by(0.0)) << off;
  EXPECT_NE(middle_by(0.1), middle_by(0.0));
}

TEST(Evidence, AMarginOfThePictureIsNoHole) {
  Wall wall(160, 120);
  for (std::size_t row = 0; row < 120; ++row)
    for (std::size_t column = 150; column < 160; ++column) wall.blank(row, column);
  EXPECT_EQ(wall.said_of(60, 140), Evidence::Nothing);
  Framing framing;
  framing.middle_row = 60.0, framing.middle_column = 80.0, framing.right = 10;
  EXPECT_EQ(wall.said_of(60, 140, &framing), Evidence::Past);
}

}  // namespace
}  // namespace safety_control_cloud
