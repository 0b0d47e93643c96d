// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/inner_pixels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace safety_control_cloud {
namespace {

/// A picture of one thing, whose pixels are x, with those that are inner or thin as o.
std::vector<std::string> chosen_in(std::vector<std::string> picture) {
  NearPixels found;
  found.slots = picture[0].size();
  for (std::size_t row = 0; row < picture.size(); ++row) {
    found.rows.push_back(row);
    for (std::size_t column = 0; column < found.slots; ++column) {
      found.ahead.push_back(picture[row][column] == '.' ? NAN : 0.5f);
      found.column.push_back(static_cast<std::uint16_t>(column));
    }
  }
  const Connected connected(found, 0.06f);
  EXPECT_EQ(connected.things().size(), std::size_t{1});
  EXPECT_EQ(pixels_of(found, connected.things()[0]).size(),
            static_cast<std::size_t>(
                std::count_if(found.ahead.begin(), found.ahead.end(), [](float ahead) { return !std::isnan(ahead); })));
  for (const NearPixels::Index i : inner_and_thin(found, connected, connected.things()[0]))
    picture[found.line_of(i)][found.slot_of(i)] = 'o';
  return picture;
}

using Picture = std::vector<std::string>;

TEST(InnerPixels, OnesThatTouchOthersOnAllSides) {
  EXPECT_EQ(chosen_in({"xxxx.", "xxxx.", "xxxx."}), Picture({"xxxx.", "xoox.", "xxxx."}));
}

TEST(InnerPixels, WhatIsTooThinToHaveAnyCountsBesideThem) {
  EXPECT_EQ(chosen_in({"xxxx......", "xxxxxxxxxx", "xxxx......", "xxxx......"}),
            Picture({"xxxx......", "xoooxooooo", "xoox......", "xxxx......"}));
}

TEST(InnerPixels, NoneIfNoneIsInner) { EXPECT_EQ(chosen_in({"xxxxxxxxxx"}), Picture({"xxxxxxxxxx"})); }

}  // namespace
}  // namespace safety_control_cloud
