// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/moved.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace safety_control_cloud {
namespace {

constexpr std::size_t width = 640, pixels_each = 100;

Spot spot(float z, bool stands = false) {
  Spot spot;
  spot.point = Point(0.0f, 0.0f, z);
  spot.stands = stands;
  return spot;
}

/// At 0.4 m each of these places is (10 pixels of 0.625 mm)^2 large.
std::vector<Backdrop::Place> places(std::size_t count) {
  std::vector<Backdrop::Place> hidden;
  for (std::size_t i = 0; i < count; ++i) hidden.push_back({100 + i, 300, 0.1f, -0.2f});
  return hidden;
}
constexpr double of_a_place = 100 * 0.000625 * 0.000625;  // [m2]

TEST(Moved, LiesWhereTheHoleIsAsFarAwayAsItWas) {
  const Moved moved{spot(0.4f), 4 * of_a_place};
  const auto spots = moved.spots_in(places(4), pixels_each, width);
  ASSERT_EQ(spots.size(), 4u);
  EXPECT_EQ(spots[3].row, 103);
  EXPECT_EQ(spots[3].column, 300);
  EXPECT_FLOAT_EQ(spots[3].point.x, 0.04f);
  EXPECT_FLOAT_EQ(spots[3].point.y, -0.08f);
  EXPECT_FLOAT_EQ(spots[3].point.z, 0.4f);
}

TEST(Moved, IsNowhereWithoutAHoleOfAQuarterOfItsSize) {
  const Moved moved{spot(0.4f), 40 * of_a_place};
  EXPECT_TRUE(moved.spots_in(places(9), pixels_each, width).empty());
  EXPECT_EQ(moved.spots_in(places(11), pixels_each, width).size(), 11u);
  EXPECT_TRUE(moved.spots_in({}, pixels_each, width).empty());
}

TEST(Moved, IsOfTheSizeOfTheHoleWhateverItIs) {
  const Moved moved{spot(0.4f), of_a_place};
  for (const std::size_t count : {1, 240, 1000, 3000}) {
    const auto spots = moved.spots_in(places(count), pixels_each, width);
    EXPECT_LE(spots.size(), 240u);
    const double size = std::accumulate(spots.begin(), spots.end(), 0.0,
                                        [](double sum, const Spot& one) { return sum + double{one.share}; });
    EXPECT_NEAR(size, static_cast<double>(count) * of_a_place, 0.05 * static_cast<double>(count) * of_a_place) << count;
  }
}

TEST(Moved, NearestOfWhatHung) {
  EXPECT_FALSE(nearest_hanging({}));
  EXPECT_FALSE(nearest_hanging({spot(0.3f, true)}));
  EXPECT_FLOAT_EQ(nearest_hanging({spot(0.5f), spot(0.3f, true), spot(0.4f)})->point.z, 0.4f);
}

TEST(Moved, LiesWithinTwoCentimetresOfWhereItWasLost) {
  Spot one = spot(0.4f), other = spot(0.8f);  // 2 cm are 32 pixels at the nearer
  one.row = 100, one.column = 200;
  other.row = 110, other.column = 250;
  const Backdrop::Part part = part_around({one, other}, width);
  for (const std::size_t row : {69u, 141u}) EXPECT_TRUE(part.holds(row, 169) && part.holds(row, 281)) << row;
  EXPECT_FALSE(part.holds(67, 200) || part.holds(143, 200) || part.holds(105, 167) || part.holds(105, 283));
}

}  // namespace
}  // namespace safety_control_cloud
