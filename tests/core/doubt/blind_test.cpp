// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/doubt/blind.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace safety_control_cloud {
namespace {

/// Clouds whose points are all valid, 20 a second.
class ValidPointsOnly {
 public:
  bool is_blind(std::size_t returns) {
    now_ += 0.05;
    return watch.note({returns, returns}, settings, now_).has_value();
  }

  bool is_blind(const Returned& cloud) {
    now_ += 0.05;
    return watch.note(cloud, settings, now_).has_value();
  }

  /// How many of them are doubted.
  int blind_of(int clouds, std::size_t returns) {
    int blind = 0;
    for (int i = 0; i < clouds; ++i) blind += is_blind(returns);
    return blind;
  }

  void pass(double seconds) { now_ += seconds; }

  BlindWatch watch;
  DoubtSettings settings;

 private:
  double now_ = 100.0;
};

TEST(Blind, CloudThatShrinksToAFewValidPointsIsNotBelieved) {
  for (const std::size_t before : {300000u, 20000u, 600u}) {
    for (const std::size_t left : {std::size_t{1}, before / 1000 + 1, before / 50, before / 11}) {
      ValidPointsOnly camera;
      camera.blind_of(20, before);
      EXPECT_TRUE(camera.is_blind(left)) << left << " of " << before;
    }
  }
}

TEST(Blind, CloudThatShrankIsBelievedAgainWhenItsPointsAreBack) {
  ValidPointsOnly camera;
  camera.blind_of(20, 300000);
  EXPECT_EQ(camera.blind_of(40, 300), 40);
  EXPECT_EQ(camera.blind_of(1, 200000), 0);
}

TEST(Blind, HundredthOfThePointsIsNeverEnoughHoweverLongItLasts) {
  ValidPointsOnly camera;
  camera.blind_of(20, 300000);
  EXPECT_EQ(camera.blind_of(20 * 3600, 2900), 20 * 3600);
  camera.watch.forget();
  EXPECT_FALSE(camera.is_blind(2900)) << "somebody has looked";
}

TEST(Blind, PauseDoesNotMakeAFewPointsEnough) {
  ValidPointsOnly camera;
  camera.blind_of(20, 300000);
  camera.pass(3600.0);
  EXPECT_TRUE(camera.is_blind(10000));
  camera.pass(3600.0);
  EXPECT_TRUE(camera.is_blind(10000));
}

TEST(Blind, OneCloudOfManyPointsAmongOthersStopsNothing) {
  ValidPointsOnly camera;
  camera.blind_of(100, 2000);
  camera.is_blind(300000);
  EXPECT_EQ(camera.blind_of(20, 2000), 0);
}

/// 5 cm voxels of what is seen at this distance: a twentieth for every 4.5th of the way.
TEST(Blind, VoxelFilterBeforeAWallThatComesNearerIsBelieved) {
  for (const double speed : {0.2, 0.5}) {
    ValidPointsOnly camera;
    int blind = 0;
    for (double z = 5.0; z > 0.51; z -= (z > 1.0 ? speed : 0.1) * 0.05) {
      blind += camera.is_blind(static_cast<std::size_t>(396.0 * z * z));
    }
    EXPECT_EQ(blind, 0) << speed << " m/s";
  }
}

TEST(Blind, WallAfterAQuickTurnFromAHallIsBelievedWithinHalfAMinute) {
  ValidPointsOnly camera;
  camera.blind_of(100, 12000);
  EXPECT_TRUE(camera.is_blind(400));
  EXPECT_LT(camera.blind_of(20 * 40, 400), 20 * 30);
  EXPECT_FALSE(camera.is_blind(400));
}

TEST(Blind, CloudThatShrankIsDoubtedForTenSecondsAtLeast) {
  ValidPointsOnly camera;
  camera.blind_of(100, 20000);
  EXPECT_EQ(camera.blind_of(20 * 10, 600), 20 * 10);
}

TEST(Blind, FewerReturnsThanTheFloorAreNoSightFromTheFirstCloudOn) {
  ValidPointsOnly camera;
  camera.settings.min_returns = 200;
  EXPECT_TRUE(camera.is_blind(199));
  EXPECT_FALSE(camera.is_blind(200));
}

TEST(Blind, CloudsOfAFewPointsMayChangeAsTheyLike) {
  ValidPointsOnly camera;
  EXPECT_FALSE(camera.is_blind(40));
  EXPECT_FALSE(camera.is_blind(1));
}

/// Its own share says how much it sees.
TEST(Blind, PictureOfALowerResolutionIsBelievedIfItTellsWhatIsMissing) {
  ValidPointsOnly camera;
  camera.is_blind({200000, 307200, true});
  EXPECT_FALSE(camera.is_blind({3000, 4800, true}));
  EXPECT_TRUE(camera.is_blind({30, 4800, true}));
  EXPECT_TRUE(camera.is_blind({4800, 4800, true})) << "all valid";
  EXPECT_TRUE(camera.is_blind({3000, 4800, false})) << "no picture";
}

TEST(Blind, NothingOfThisHoldsWhereTheRatioIsOff) {
  ValidPointsOnly camera;
  camera.settings.min_valid_ratio = 0.0;
  camera.blind_of(20, 300000);
  EXPECT_FALSE(camera.is_blind(1));
  EXPECT_TRUE(camera.is_blind(0));
}

}  // namespace
}  // namespace safety_control_cloud
