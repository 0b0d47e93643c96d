// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/input/probes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cloud_builder.hpp"

namespace safety_control_cloud {
namespace {

std::size_t missing_in(const Probes& probes) {
  return static_cast<std::size_t>(
      std::count_if(probes.depths.begin(), probes.depths.end(), [](float depth) { return std::isnan(depth); }));
}

TEST(Probes, AreSpreadOverThePicture) {
  std::vector<Xyz> points;
  for (std::size_t i = 0; i < 16 * 24; ++i) points.push_back({0.0f, 0.0f, 1.0f + static_cast<float>(i)});
  CloudView view = view_of(points);
  view.width = 24, view.height = 16, view.row_step = 24 * sizeof(Xyz);
  const Probes probes(view);
  EXPECT_EQ(missing_in(probes), std::size_t{0});
  EXPECT_EQ(probes.depths.front(), 1.0f + 24.0f + 1.0f) << "row 1, column 1";
  EXPECT_EQ(probes.depths.back(), 1.0f + 15.0f * 24.0f + 22.0f);
}

TEST(Probes, OfWhatDoesNotReturnAreNone) {
  std::vector<Xyz> points(64, Xyz{0.0f, 0.0f, 2.0f});
  points[0] = {nan, 0.0f, 2.0f}, points[1] = {0.0f, 0.0f, -1.0f}, points[2] = {0.0f, 0.0f, inf};
  CloudView view = view_of(points);
  EXPECT_EQ(missing_in(Probes(view)), std::size_t{64}) << "no picture";
  view.width = 8, view.height = 8, view.row_step = 8 * sizeof(Xyz);
  EXPECT_EQ(missing_in(Probes(view)), std::size_t{3});
}

}  // namespace
}  // namespace safety_control_cloud
