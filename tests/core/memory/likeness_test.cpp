// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/likeness.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

/// Spots a centimetre apart, from left to right, this far to the right and away [m].
std::vector<Spot> row_of_spots(std::size_t count, float right, float away) {
  std::vector<Spot> spots(count);
  for (std::size_t i = 0; i < count; ++i) spots[i].point = {right + 0.01f * static_cast<float>(i), 0.0f, away};
  return spots;
}

Likeness after_a_move(float right, float nearer) {
  Thing now;
  now.spots = row_of_spots(200, right, 0.8f - nearer);
  return likeness_of(row_of_spots(200, 0.0f, 0.8f), now);
}

TEST(Likeness, OfAThingThatRestsIsWhole) {
  const Likeness alike = after_a_move(0.0f, 0.0f);
  EXPECT_DOUBLE_EQ(alike.share, 1.0);
  EXPECT_DOUBLE_EQ(alike.closeness, 1.0);
}

TEST(Likeness, FallsWithHowFarAThingHasCome) {
  const Likeness alike = after_a_move(0.0f, 0.05f);
  EXPECT_DOUBLE_EQ(alike.share, 1.0);
  EXPECT_NEAR(alike.closeness, 1.0 - 0.05 / 0.15, 1e-5);
  EXPECT_DOUBLE_EQ(after_a_move(0.0f, 0.16f).share, 0.0) << "faster than 3 m/s";
  EXPECT_NEAR(after_a_move(0.0f, 0.16f).closeness, 0.0, 1e-6);
}

TEST(Likeness, CountsWhatOfTheThingIsCloseToWhatIsSeen) {
  EXPECT_NEAR(after_a_move(1.0f, 0.0f).share, 0.57, 0.05) << "half of two metres, and what a step reaches beyond it";
  EXPECT_DOUBLE_EQ(after_a_move(3.0f, 0.0f).share, 0.0);
}

TEST(Likeness, OfNothingIsNone) {
  EXPECT_DOUBLE_EQ(likeness_of({}, Thing{}).share, 0.0);
  EXPECT_DOUBLE_EQ(likeness_of(row_of_spots(9, 0.0f, 0.8f), Thing{}).share, 0.0);
}

}  // namespace
}  // namespace safety_control_cloud
