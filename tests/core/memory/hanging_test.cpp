// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/hanging.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

Spot spot_at(float right, bool stands, bool foot_unseen) {
  Spot spot;
  spot.point = {right, 0.0f, 0.5f};
  spot.stands = stands, spot.foot_unseen = foot_unseen;
  return spot;
}

/// Of something at 0, below which nothing is seen any more.
Spot after(const std::vector<Spot>& shown, const std::vector<Spot>& lost = {}) {
  std::vector<Thing> seen(1);
  seen[0].spots = {spot_at(0.0f, false, true)};
  keep_hanging(seen, {&shown, &lost});
  return seen[0].spots[0];
}

const Spot hanging = spot_at(0.05f, false, false), standing = spot_at(0.05f, true, false);

TEST(Hanging, WhatHungStillDoesThoughSomethingHidesWhatIsBelowIt) {
  for (const Spot& now : {after({hanging}), after({}, {hanging})}) {
    EXPECT_TRUE(now.hung_before);
    EXPECT_FALSE(now.foot_unseen);
  }
}

TEST(Hanging, WhatStoodOrWasNotSeenOrIsFarAwayTellsNothing) {
  for (const Spot& now :
       {after({}), after({standing}), after({spot_at(0.05f, false, true)}), after({spot_at(0.16f, false, false)})}) {
    EXPECT_FALSE(now.hung_before);
    EXPECT_TRUE(now.foot_unseen);
  }
}

TEST(Hanging, WhatHungStillDoesThoughItsFootIsThatOfWhatIsRightBehindIt) {
  for (const float overhang : {0.0f, 0.012f}) {
    std::vector<Thing> seen(1);
    const std::vector<Spot> before{hanging};
    seen[0].spots = {spot_at(0.0f, true, false)};
    seen[0].spots[0].overhang = overhang;
    keep_hanging(seen, {&before});
    EXPECT_EQ(seen[0].spots[0].hung_before, overhang > 0.0f);
    EXPECT_EQ(seen[0].spots[0].stands, overhang == 0.0f);
  }
}

TEST(Hanging, TheNearestDecidesAndOfTwoThatAreAsNearTheOneThatHung) {
  EXPECT_FALSE(after({hanging, spot_at(0.02f, true, false)}).hung_before);
  EXPECT_TRUE(after({standing, spot_at(0.02f, false, false)}).hung_before);
  EXPECT_TRUE(after({standing, hanging}).hung_before);
  EXPECT_TRUE(after({hanging}, {standing}).hung_before);
}

TEST(Hanging, WhatIsBelowIsSeenAsItIs) {
  std::vector<Thing> seen(1);
  const std::vector<Spot> before{hanging};
  seen[0].spots = {spot_at(0.0f, true, false)};
  keep_hanging(seen, {&before});
  EXPECT_TRUE(seen[0].spots[0].stands);
  EXPECT_FALSE(seen[0].spots[0].hung_before);
}

/// Of an edge at 0, above what hides its foot.
bool stands_after(const std::vector<Spot>& shown, bool is_edge = true) {
  std::vector<Thing> seen(1);
  seen[0].spots = {spot_at(0.0f, false, true), spot_at(0.01f, false, true)};
  seen[0].is_edge = is_edge;
  keep_standing(seen, {&shown});
  return seen[0].stands;
}

TEST(Hanging, AnEdgeStandsIfWhatIsNearestToEachPartOfItStood) {
  EXPECT_TRUE(stands_after({standing}));
  EXPECT_TRUE(stands_after({standing, spot_at(0.08f, false, false)}));
  EXPECT_FALSE(stands_after({standing}, false)) << "more than an edge";
  EXPECT_FALSE(stands_after({}));
  EXPECT_FALSE(stands_after({spot_at(0.17f, true, false)})) << "farther than anything moves";
  EXPECT_FALSE(stands_after({standing, spot_at(0.03f, false, false)}));
  EXPECT_FALSE(stands_after({standing, spot_at(-0.02f, false, true)})) << "unknown";
}

}  // namespace
}  // namespace safety_control_cloud
