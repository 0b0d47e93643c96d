// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/input/extent.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace safety_control_cloud {
namespace {

constexpr std::uint32_t largest = std::numeric_limits<std::uint32_t>::max();

Extent rows(std::uint32_t height, std::uint32_t width, std::uint64_t step, std::uint64_t row_step) {
  return {height, width, {"point_step", step}, {"row_step", row_step}};
}

TEST(Extent, RowsThatFillTheBytesAreFit) {
  EXPECT_FALSE(problem_with(rows(3, 4, 12, 48), 144));
  EXPECT_FALSE(problem_with(rows(3, 4, 12, 64), 192)) << "with a gap behind each row";
  EXPECT_FALSE(problem_with(rows(0, 0, 0, 0), 0));
}

TEST(Extent, WhatIsWrongIsNamedAsTheMessageNamesIt) {
  EXPECT_EQ(problem_with(rows(3, 4, 12, 47), 141), "row_step 47 is less than width x point_step = 48");
  EXPECT_EQ(problem_with(rows(3, 4, 12, 48), 143), "data has 143 bytes, not height x row_step = 144");
  EXPECT_EQ(problem_with(rows(3, 4, 12, 48), 145), "data has 145 bytes, not height x row_step = 144");
}

/// In 32 bits 65536 x 65536 is 0, and no bytes would do.
TEST(Extent, LargestClaimsDoNotWrap) {
  EXPECT_TRUE(problem_with(rows(1, 65536, 65536, 0), 0));
  EXPECT_TRUE(problem_with(rows(65536, 1, 1, 65536), 0));
  EXPECT_TRUE(problem_with(rows(largest, largest, largest, largest), 1));
}

TEST(Extent, FourBillionEmptyRowsAreNone) {
  EXPECT_EQ(rows_in(rows(largest, 0, 12, 0)), std::size_t{0});
  EXPECT_EQ(rows_in(rows(3, 4, 12, 48)), std::size_t{3});
}

}  // namespace
}  // namespace safety_control_cloud
