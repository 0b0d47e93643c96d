// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/blank_shares.hpp"

#include <gtest/gtest.h>

#include <random>

namespace safety_control_cloud {
namespace {

constexpr std::size_t columns = 160, rows = 4, post = 6;

/// Of which `hidden` are blank from the left on, and of the others as many pixels as chance has it.
std::vector<std::uint16_t> blank(double chance, std::size_t hidden, std::mt19937& random) {
  std::binomial_distribution<int> any(static_cast<int>(rows), chance);
  std::vector<std::uint16_t> counts(columns, static_cast<std::uint16_t>(rows));
  for (std::size_t i = hidden; i < columns; ++i) counts[i] = static_cast<std::uint16_t>(any(random));
  return counts;
}

TEST(BlankShares, InOrdinaryLightTheLatestCloudTells) {
  std::mt19937 random(1);
  BlankShares shares;
  shares.note(blank(0.0, 0, random), rows, post);
  for (const std::size_t hidden : {post, std::size_t{0}}) {
    shares.note(blank(0.0, hidden, random), rows, post);
    EXPECT_EQ(shares.clouds(), 1.0);
    EXPECT_EQ(shares[0], hidden > 0 ? 1.0 : 0.0);
    EXPECT_EQ(shares[columns - 1], 0.0);
  }
}

TEST(BlankShares, TheMoreIsBlankByChanceTheMoreCloudsAreAsked) {
  std::mt19937 random(1);
  double before = 0.0;
  for (const double chance : {0.3, 0.5, 0.6, 0.9}) {
    BlankShares shares;
    for (int i = 0; i < 40; ++i) shares.note(blank(chance, 0, random), rows, post);
    EXPECT_GT(shares.clouds(), before) << chance;
    before = shares.clouds();
  }
  EXPECT_LE(before, 16.0);
}

TEST(BlankShares, WhatHidesLessThanHalfOfTheFloorIsNoChance) {
  std::mt19937 random(1);
  BlankShares shares;
  for (int i = 0; i < 40; ++i) shares.note(blank(0.0, columns / 2 - 10, random), rows, post);
  EXPECT_EQ(shares.clouds(), 1.0);
  EXPECT_EQ(shares[0], 1.0);
}

TEST(BlankShares, ColumnsOfWhichNoPixelReturnsTellAtOnceInLowLightToo) {
  std::mt19937 random(1);
  BlankShares shares;
  for (int i = 0; i < 40; ++i) shares.note(blank(0.4, 0, random), rows, post);
  ASSERT_GT(shares.clouds(), 1.0);
  shares.note(blank(0.4, 3 * post, random), rows, post);
  for (std::size_t i = 0; i < 3 * post; ++i) EXPECT_EQ(shares[i], 1.0) << i;
}

TEST(BlankShares, OfNoRowsNothingIsTold) {
  std::mt19937 random(1);
  BlankShares shares;
  shares.note(blank(0.0, 0, random), rows, post);
  shares.note(std::vector<std::uint16_t>(columns, 0), 0, post);
  EXPECT_EQ(shares[0], 0.0);
}

}  // namespace
}  // namespace safety_control_cloud
