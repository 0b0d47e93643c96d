// SPDX-License-Identifier: BSD-3-Clause
// What stands too near to return, but for a border or an edge that is seen; and what hangs beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

struct Block {
  std::size_t from, to;    ///< columns
  std::size_t top, below;  ///< rows
  float z;                 ///< [m]; NaN: too near to return
};

constexpr std::size_t width = 320, height = 240;

/// What a camera sees of a hall, or of a wall at this distance, and of the floor, and of what is before that.
class Picture {
 public:
  explicit Picture(const std::vector<Block>& blocks = {}, float wall = inf) : points_(width * height) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const std::size_t row = i / width, column = i % width;
      const float down = (static_cast<float>(row) - 119.5f) / focal;
      float z = std::min(wall, down > 0.0f ? floor_y / down : inf);
      for (const Block& block : blocks) {
        if (column >= block.from && column < block.to && row >= block.top && row < block.below) z = block.z;
      }
      set(i, z < 5.0f ? z : nan);
    }
  }

  /// Of the pixels that return nothing, so large a share returns anything beyond the zones.
  Picture& stray(double share, std::mt19937& random) {
    std::bernoulli_distribution strays(share);
    std::uniform_real_distribution<float> anywhere(1.1f, 5.0f);
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (std::isnan(points_[i].z) && strays(random)) set(i, anywhere(random));
    return *this;
  }

  /// Of what is nearer than the floor in these columns, ever less returns from one row down to the other.
  Picture& fray(std::size_t from, std::size_t to, std::size_t top, std::size_t below, std::mt19937& random) {
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    for (std::size_t row = top; row < height; ++row) {
      const double gone = static_cast<double>(row - top) / static_cast<double>(below - top);
      for (std::size_t column = from; column < to; ++column)
        if (chance(random) < gone) set(row * width + column, nan);
    }
    return *this;
  }

  CloudView view() const {
    CloudView view = view_of(points_);
    view.width = width, view.height = height, view.row_step = width * sizeof(Xyz);
    return view;
  }

 private:
  static constexpr float focal = 277.0f;  // [pixel]

  void set(std::size_t i, float z) {
    const float right = (static_cast<float>(i % width) - 159.5f) / focal,
                down = (static_cast<float>(i / width) - 119.5f) / focal;
    points_[i] = {right * z, down * z, z};
  }

  std::vector<Xyz> points_;
};

class StandingBeside : public testing::TestWithParam<double> {
 protected:
  Decision sees(const std::vector<Block>& blocks, int clouds = 1) {
    Decision decision;
    for (int i = 0; i < clouds; ++i) decision = robot_.sees(Picture(blocks, wall_).stray(GetParam(), random_).view());
    return decision;
  }
  void begins(float wall = inf) {
    robot_ = Robot();
    wall_ = wall;
    sees({}, 10);
  }
  void stands_for_good(const std::vector<Block>& blocks = {}) {
    for (int i = 0; i < 60; ++i) ASSERT_EQ(sees(blocks).speed, 0.0) << i;
  }

  std::mt19937 random_{11};
  Robot robot_;

 private:
  float wall_ = inf;
};
INSTANTIATE_TEST_SUITE_P(Strays, StandingBeside, testing::Values(0.0, 0.001, 0.01, 0.1));

Block column(std::size_t at, std::size_t below, float z = 0.408f, std::size_t columns = 1) {
  return {at, at + columns, 0, below, z};
}
Block too_near(std::size_t from, std::size_t to) { return {from, to, 0, height, nan}; }
Block leg(std::size_t from, std::size_t to, float z) { return {from, to, 0, height, z}; }

TEST_P(StandingBeside, RobotDrivesOnWhenALegHasGoneWhoseFrontFrayedDownward) {
  for (const std::size_t top : {20u, 80u, 140u}) {
    begins();
    for (const float z : {0.6f, 0.5f, 0.42f}) sees({leg(150, 210, z)}, 2);
    for (int i = 0; i < 5; ++i) {
      Picture picture({leg(150, 210, 0.401f)});
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
