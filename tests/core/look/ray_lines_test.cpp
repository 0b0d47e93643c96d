// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/look/ray_lines.hpp"

#include <gtest/gtest.h>

#include "../memory/lens.hpp"

namespace safety_control_cloud {
namespace {

const std::vector<Board> wall = {{2.0f, -9.0f, 9.0f, -9.0f, floor_y}};

void expect_those_of(const Lens& lens, const RayLines& lines) {
  ASSERT_TRUE(lines.across && lines.down);
  EXPECT_NEAR(lines.across->slope * lens.focal, 1.0, 1e-4);
  EXPECT_NEAR(lines.down->slope * lens.focal, 1.0, 1e-4);
  EXPECT_NEAR(lines.across->pixel(0.0), lens.across, 0.01);
  EXPECT_NEAR(lines.down->pixel(0.0), lens.down, 0.01);
}

TEST(RayLines, OfACloudAndADepthImageAreThoseOfTheCamera) {
  const Lens whole;
  for (const Lens& lens : {whole, whole.part(80, 0, 80, 120), whole.part(0, 70, 160, 50), Lens::of(42.0)}) {
    const auto points = lens.points(wall);
    expect_those_of(lens, ray_lines_of(lens.view_of_rows(points)));
    const auto depths = lens.depths(points);
    expect_those_of(lens, ray_lines_of(lens.view_of_depths(depths)));
  }
}

TEST(RayLines, OfAPieceOfADepthImageAreThoseOfItsPixels) {
  const Lens lens;
  const std::vector<float> depths(lens.width * lens.height, 1.0f);
  DepthView piece = lens.view_of_depths(depths);
  piece.first_column = 10, piece.first_row = 20, piece.width = 50, piece.height = 60;
  expect_those_of(lens.part(10, 20, 50, 60), ray_lines_of(piece));
}

TEST(RayLines, AreNotKnownWhereNothingTells) {
  const Lens lens;
  const auto known = [&](const std::vector<Xyz>& points) {
    const RayLines lines = ray_lines_of(lens.view_of_rows(points));
    return lines.across || lines.down;
  };
  EXPECT_FALSE(known(std::vector<Xyz>(lens.width * lens.height, {nan, nan, nan})));
  EXPECT_FALSE(known(std::vector<Xyz>(lens.width * lens.height, {0.1f, 0.2f, 1.0f}))) << "all look one way";
  const auto points = lens.points(wall);
  const RayLines unorganised = ray_lines_of(view_of(points));
  EXPECT_FALSE(unorganised.across || unorganised.down);
}

}  // namespace
}  // namespace safety_control_cloud
