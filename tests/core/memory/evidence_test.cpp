// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/evidence.hpp"

#include <gtest/gtest.h>

#include "../input/cloud_builder.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::size_t size = 9;  ///< pixels across and down

/// What a picture says of a thing at 0.4 m in its middle, of which five of nine pixels returned; those return these.
Evidence said(const std::vector<float>& ranges) {
  std::vector<Xyz> points(size * size, Xyz{nan, nan, nan});
  const std::size_t middle = size / 2;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    points[(middle - 1 + i / 3) * size + middle - 1 + i % 3] = {0.0f, 0.0f, ranges[i]};
  }
  CloudView view = view_of(points);
  view.width = view.height = size;
  view.row_step = size * sizeof(Xyz);
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

}  // namespace
}  // namespace safety_control_cloud
