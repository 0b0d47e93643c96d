// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/kept_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace safety_control_cloud {
namespace {

KeptPlaces some(std::size_t count, double spread) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-spread, spread);
  KeptPlaces kept{1000.25, Pose2{{5.2e5 + 0.125, -5.4e6}, 2.5}, {}};
  for (std::size_t i = 0; i < count; ++i) kept.all.push_back({{any(random), any(random)}, 0.3, 0.02});
  return kept;
}

/// Whether some place of `kept` covers this one.
bool covers(const KeptPlaces& kept, const KeptPlace& one) {
  return std::any_of(kept.all.begin(), kept.all.end(), [&](const KeptPlace& place) {
    return length_of(place.place - one.place) + one.off <= place.off + 2e-6 &&
           std::abs(place.height - one.height) <= 0.05;
  });
}

TEST(KeptPlaces, TextCoversEachPlace) {
  const KeptPlaces kept = some(500, 1.5);
  const auto read = kept_places_in(to_text(kept));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->stamp, kept.stamp);
  ASSERT_TRUE(read->robot && kept.robot);
  EXPECT_EQ(read->robot->place.x, kept.robot->place.x);
  EXPECT_EQ(read->robot->place.y, kept.robot->place.y);
  EXPECT_EQ(read->robot->heading, kept.robot->heading);
  for (const KeptPlace& one : kept.all) EXPECT_TRUE(covers(*read, one)) << one.place.x << ' ' << one.place.y;
  for (const KeptPlace& one : read->all) EXPECT_LE(one.off, 0.02 + 0.031);
}

/// A process that is killed again and again does not widen what it has not placed yet.
TEST(KeptPlaces, TextOfATextIsHardlyWider) {
  KeptPlaces kept = some(100, 1.5);
  for (int i = 0; i < 5; ++i) kept = *kept_places_in(to_text(kept));
  for (const KeptPlace& one : kept.all) EXPECT_LE(one.off, 0.02 + 0.031);
}

TEST(KeptPlaces, OfTooManyTheNearestAreKept) {
  const KeptPlaces kept = some(60000, 3.0);
  const std::string text = to_text(kept);
  EXPECT_LT(text.size(), std::size_t{50000});
  const auto read = kept_places_in(text);
  ASSERT_TRUE(read);
  for (const KeptPlace& one : kept.all) {
    if (length_of(one.place) < 0.9) {
      EXPECT_TRUE(covers(*read, one));
    }
  }
}

/// As it is in ten minutes.
TEST(KeptPlaces, WhatLiesFarAwayOrMayBeAnywhereKeepsNothingElseFromBeingRead) {
  KeptPlaces kept = some(3, 1.5);
  kept.all.push_back({{150.0, -4000.0}, 0.3, 3.0});
  kept.all.push_back({{2.0, 0.0}, 0.3, 1e9});
  const auto read = kept_places_in(to_text(kept));
  ASSERT_TRUE(read);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(covers(*read, kept.all[i])) << i;
  EXPECT_EQ(read->all.size(), kept.all.size());
}

TEST(KeptPlaces, EachIsOfTheSensorThatShowedIt) {
  KeptPlaces kept = some(3, 1.5);
  for (std::size_t i = 0; i < 3; ++i) kept.all[i].sensor = 2 - i;
  kept.sensors = {"front", "rear", "laser"};
  const auto read = kept_places_in(to_text(kept));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->sensors, kept.sensors);
  for (const KeptPlace& one : read->all) {
    const auto is_it = [&](const KeptPlace& place) { return length_of(place.place - one.place) < 0.03; };
    EXPECT_EQ(one.sensor, std::find_if(kept.all.begin(), kept.all.end(), is_it)->sensor);
  }
}

TEST(KeptPlaces, OfNoneNothingIsWritten) {
  EXPECT_EQ(to_text(KeptPlaces{}), "");
  const auto read = kept_places_in(to_text({1.0, std::nullopt, {}}));
  ASSERT_TRUE(read) << "but that they may be anywhere";
  EXPECT_FALSE(read->robot);
  EXPECT_TRUE(read->all.empty());
}

TEST(KeptPlaces, WhatIsNotWholeIsNotRead) {
  const std::string text = to_text(some(3, 1.0));
  ASSERT_TRUE(kept_places_in(text));
  for (std::size_t length = 0; length + 1 < text.size(); ++length)
    EXPECT_FALSE(kept_places_in(text.substr(0, length))) << length;
  EXPECT_TRUE(kept_places_in("places-3 1 1 0 0 0 1 - 1 1 1 1 1 end"));
  EXPECT_FALSE(kept_places_in("places-3 1 2 0 0 0 1 - 1 1 1 1 1 end"));
  EXPECT_FALSE(kept_places_in("places-3 nan 1 0 0 0 1 - 1 1 1 1 1 end"));
  EXPECT_FALSE(kept_places_in("places-3 1 1 0 0 0 1 - 1 1 1 1 -1 end"));
  EXPECT_FALSE(kept_places_in("places-3 1 1 0 0 0 1 - 4294967295 end"));
}

}  // namespace
}  // namespace safety_control_cloud
