// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/look/ray_samples.hpp"

#include <gtest/gtest.h>

#include "../input/cloud_builder.hpp"
#include "../scene.hpp"

namespace safety_control_cloud {
namespace {

CloudView view_in_rows(const std::vector<Xyz>& points, std::size_t width) {
  CloudView view = view_of(points);
  view.width = width, view.height = points.size() / width, view.row_step = width * sizeof(Xyz);
  return view;
}

TEST(RaySamples, AreSpreadOverThePicture) {
  const std::vector<Xyz> points(160 * 120, Xyz{1.0f, 2.0f, 4.0f});
  const RaySamples samples{view_in_rows(points, 160)};
  EXPECT_EQ(samples.ahead, RaySamples::rows * RaySamples::columns);
  EXPECT_EQ(samples.in_row.front().front().column, 5.0) << "the middle of the first sixteenth";
  EXPECT_EQ(samples.in_row.back().back().column, 155.0);
  EXPECT_EQ(samples.in_column.back().back().row, 115.0);
  EXPECT_EQ(samples.in_row[3].size(), RaySamples::columns);
  EXPECT_EQ(samples.in_row[3][3].x, 0.25);
  EXPECT_EQ(samples.in_row[3][3].y, 0.5);
}

TEST(RaySamples, WhatIsBehindIsCountedAndWhatIsNothingIsNot) {
  const auto behind = [](Xyz point) {
    const std::vector<Xyz> points(16 * 12, point);
    const RaySamples samples{view_in_rows(points, 16)};
    EXPECT_EQ(samples.ahead, std::size_t{0});
    return samples.behind;
  };
  EXPECT_EQ(behind({0.0f, 0.0f, -1.0f}), std::size_t{192});
  EXPECT_EQ(behind({1.0f, 0.0f, 0.0f}), std::size_t{192}) << "beside the camera";
  EXPECT_EQ(behind({0.0f, 0.0f, 0.0f}), std::size_t{0});
  EXPECT_EQ(behind({nan, nan, nan}), std::size_t{0});
  EXPECT_EQ(behind({0.0f, 0.0f, inf}), std::size_t{0});
}

}  // namespace
}  // namespace safety_control_cloud
