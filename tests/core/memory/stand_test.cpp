// SPDX-License-Identifier: BSD-3-Clause
// What stands too near to return, but for a border or an edge that is seen; and what hangs beside it.
#include <gtest/gtest.h>

#include <vector>

#include "../sanitized.hpp"
#include "standing_beside.hpp"

namespace safety_control_cloud {
namespace {

INSTANTIATE_TEST_SUITE_P(Strays, StandingBeside, testing::ValuesIn(some_of<double>({0.0, 0.001, 0.01, 0.1})));

TEST_P(StandingBeside, RobotDrivesOnWhenALegHasGoneWhoseFrontFrayedDownward) {
  for (const std::size_t top : {20u, 80u, 140u}) {
    begins();
    for (const float z : {0.6f, 0.5f, 0.42f}) sees({leg(150, 210, z)}, 2);
    for (int i = 0; i < 5; ++i) {
      Hall picture({leg(150, 210, 0.401f)});
      picture.fray(160, 200, top, top + 90, random_).stray(GetParam(), random_);
      EXPECT_EQ(robot_.sees(picture.view()).speed, 0.0) << top;
    }
    sees({too_near(150, 210)}, 5);
    EXPECT_EQ(sees({}, 10).speed, 0.2) << top;
  }
}

TEST_P(StandingBeside, RobotDrivesOnWhenALegHasGoneThatLeanedAndOfWhichACornerAtThePicturesTopWasLost) {
  begins(4.5f);
  for (const float z : {0.6f, 0.5f, 0.42f}) sees({leg(60, 100, z)}, 2);
  sees({too_near(60, 100)}, 3);
  EXPECT_EQ(sees({leg(60, 100, 0.42f), {60, 68, 0, 22, 4.5f}}).speed, 0.0);
  EXPECT_EQ(sees({}, 10).speed, 0.2);
}

TEST_P(StandingBeside, SliverStaysBesideWhatIsHiddenIfNothingWasSeenToStandThere) {
  begins();
  sees({too_near(150, 203)}, 10);
  sees({too_near(150, 203), column(203, 112)}, 2);
  sees({too_near(150, 203)}, 3);
  stands_for_good();
}

TEST_P(StandingBeside, BoardOfFortyCentimetresStaysThatCameAboveALowThingNobodySaw) {
  for (const std::size_t top_of_it : {132u, 145u, 161u}) {
    const Block low = {60, 260, top_of_it, height, nan};
    begins();
    sees({low}, 10);
    for (const float z : {0.55f, 0.5f, 0.45f, 0.41f}) {
      const auto half = static_cast<std::size_t>(0.2f / z * 277.0f);
      const auto below = 120 + static_cast<std::size_t>(0.017f / z * 277.0f);
      sees({low, {160 - std::min<std::size_t>(160, half), std::min(width, 160 + half), 0, below, z}});
    }
    sees({low, {0, width, 0, 134, nan}}, 5);
    for (int i = 0; i < 60; ++i) ASSERT_EQ(sees({{0, width, 0, 134, nan}}).speed, 0.0) << top_of_it << ", " << i;
  }
}

TEST_P(StandingBeside, BoardStaysThatIsSeenByItsFarEdgeAloneAboveALowThing) {
  const Block low = {100, 204, 132, height, nan};
  begins();
  for (const float z : {0.6f, 0.5f, 0.42f}) sees({{100, 204, 132, height, z}}, 2);
  sees({low}, 5);
  sees({low, {100, 202, 0, 134, nan}, {202, 204, 0, 134, 0.402f}}, 3);
  sees({low, {100, 204, 0, 134, nan}}, 3);
  stands_for_good();
}

TEST_P(StandingBeside, BagStaysWhenTheLegHasGoneBesideWhichItHung) {
  const Block hidden = too_near(150, 203);
  begins();
  for (const float z : {0.6f, 0.5f, 0.42f}) sees({leg(150, 203, z), column(203, 112, z, 30)}, 2);
  sees({hidden, {203, 233, 0, 112, nan}, column(203, 112)});
  sees({hidden, {203, 240, 0, 112, nan}});
  stands_for_good({{203, 240, 0, 112, nan}});
}

TEST_P(StandingBeside, CordThatWasSeenToHangStaysThoughALegStoodBesideItLast) {
  for (const int clouds_blank : {0, 1, 3}) {
    begins();
    for (const float z : {0.6f, 0.5f, 0.42f}) sees({leg(212, 258, z)}, 2);
    sees({column(202, 112, 0.42f, 2)}, 3);
    sees({}, clouds_blank);
    sees({too_near(204, 250), column(202, 112, 0.41f, 2)}, 3);
    sees({too_near(204, 250)}, 3);
    stands_for_good();
  }
}

TEST_P(StandingBeside, RailStaysWhenTheLegHasGoneBesideWhichItWasSeenLast) {
  const Block hidden = too_near(150, 203);
  begins();
  for (const float z : {0.6f, 0.5f, 0.42f}) sees({leg(150, 203, z)}, 2);
  sees({hidden, {203, 290, 60, 68, 0.42f}});
  sees({hidden, {203, 290, 60, 68, 0.405f}});
  sees({hidden}, 3);
  stands_for_good();
}

TEST_P(StandingBeside, BarThatWasSeenToHangStaysThoughTheFloorBelowItWasHiddenAsItTouchedALeg) {
  const auto touches = [](float z, std::size_t hidden_from) {
    return std::vector<Block>{{203, 233, hidden_from, height, nan}, leg(140, 203, z), {203, 233, 60, 80, z}};
  };
  for (const float last : {0.41f, 0.45f}) {
    begins();
    for (const float z : {0.6f, 0.55f, 0.51f}) sees(touches(z, height), 2);
    for (const float z : {0.49f, 0.47f, last}) sees(touches(z, 80), 2);
    sees({too_near(140, 233)}, 3);
    stands_for_good();
  }
}

TEST_P(StandingBeside, BarStaysOfWhichOnlyAPartTouchedALeg) {
  const auto touches = [](float z, std::size_t hidden_from) {
    return std::vector<Block>{{203, 233, hidden_from, height, nan}, leg(80, 203, z), {203, 263, 50, 90, z}};
  };
  for (int i = 0; i < 10; ++i) {
    begins();
    for (const float z : {0.6f, 0.55f, 0.51f}) sees(touches(z, height), 2);
    for (const float z : {0.49f, 0.47f, 0.43f}) sees(touches(z, 90), 2);
    sees({too_near(80, 263)}, 3);
    stands_for_good({{203, 233, 40, 96, 4.0f}});
  }
}

TEST_P(StandingBeside, BarStaysThatHungBeforeALegHoweverLittleFartherTheLegWas) {
  for (const float behind : {0.025f, 0.03f, 0.04f, 0.055f, 0.07f}) {
    for (const std::size_t reach : {0u, 20u}) {  // beside the leg
      const auto before_it = [&](float z) {
        return std::vector<Block>{leg(140, 203, z + behind), {140 - reach, 203 + reach, 60, 90, z}};
      };
      begins();
      for (const float z : {0.6f, 0.55f, 0.5f, 0.45f, 0.41f}) sees(before_it(z), 2);
      sees({too_near(140, 203), {140 - reach, 203 + reach, 60, 90, nan}}, 3);
      stands_for_good();
    }
  }
}

TEST_P(StandingBeside, BarStaysThatWasSeenToHangBeforeALegCameRightBehindIt) {
  for (const float behind : {0.012f, 0.015f, 0.018f}) {
    begins();
    for (const float z : {0.6f, 0.5f, 0.45f}) sees({{150, 190, 60, 90, z}}, 2);
    for (const float gap : {0.05f, 0.03f, behind}) sees({leg(140, 203, 0.45f + gap), {150, 190, 60, 90, 0.45f}}, 2);
    for (const float z : {0.43f, 0.41f}) sees({leg(140, 203, z + behind), {150, 190, 60, 90, z}}, 2);
    sees({too_near(140, 203), {150, 190, 60, 90, nan}}, 3);
    stands_for_good();
  }
}

TEST_P(StandingBeside, SmallThingStaysThatHungBeforeALargeOneAndWasLostWhileThatWasSeen) {
  for (const float behind : {0.025f, 0.04f, 0.055f}) {
    for (const std::size_t wide : {16u, 40u}) {
      const auto hung = [=](float z) { return Block{160 - wide / 2, 160 + wide / 2, 90, 110, z}; };
      begins();
      for (const float z : {0.6f, 0.55f, 0.5f, 0.45f, 0.41f}) sees({leg(60, 260, z + behind), hung(z)}, 2);
      sees({leg(60, 260, 0.43f), hung(nan)}, 5);
      for (int i = 0; i < 60; ++i) EXPECT_EQ(sees({hung(nan)}).speed, 0.0) << behind << ", " << wide << ", " << i;
    }
  }
}

TEST_P(StandingBeside, RobotDrivesOnWhenALegHasGoneThatLeanedForwardAndHadAFootBeforeIt) {
  std::vector<Block> leaning;
  for (std::size_t row = 0; row < height; row += 8)
    leaning.push_back({140, 203, row, row + 8, 0.45f + 0.003f * static_cast<float>(row / 8)});
  leaning.push_back({140, 203, 224, height, 0.5f});
  begins();
  sees(leaning, 5);
  sees({too_near(140, 203)}, 3);
  EXPECT_EQ(sees({}, 10).speed, 0.2);
}

TEST_P(StandingBeside, PostOfTwoCentimetresStaysUntilItGoesWhenTheLegBesideItHasGone) {
  const Block hidden = too_near(150, 203), post = too_near(203, 217);
  begins();
  for (const float z : {0.6f, 0.5f, 0.42f}) sees({leg(150, 203, z)}, 2);
  sees({hidden, column(203, height, 0.41f, 14)}, 2);
  sees({hidden, post, column(216, 112)}, 2);
  stands_for_good({post});
  EXPECT_EQ(sees({}, 10).speed, 0.2);
}

}  // namespace
}  // namespace safety_control_cloud
