// SPDX-License-Identifier: BSD-3-Clause
// Of what stands too near to return, an edge that is seen; and what hangs beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
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

class HiddenEdges : public testing::TestWithParam<double> {
 protected:
  Decision sees(std::vector<Block> blocks, int clouds = 1) {
    if (always_) blocks.push_back(*always_);
    Decision decision;
    for (int i = 0; i < clouds; ++i) decision = robot_.sees(Picture(blocks, wall_).stray(GetParam(), random_).view());
    return decision;
  }
  void begins(float wall = inf) {
    robot_ = Robot();
    wall_ = wall;
    sees({}, 10);
  }
  void shows_always(const Block& block) { always_ = block; }

 private:
  std::mt19937 random_{11};
  Robot robot_;
  float wall_ = inf;
  std::optional<Block> always_;
};
INSTANTIATE_TEST_SUITE_P(Strays, HiddenEdges, testing::Values(0.0, 0.001, 0.01, 0.1));

Block column(std::size_t at, std::size_t below, float z = 0.408f, std::size_t columns = 1) {
  return {at, at + columns, 0, below, z};
}
Block too_near(std::size_t from, std::size_t to) { return {from, to, 0, height, nan}; }

TEST_P(HiddenEdges, RobotDrivesOnWhenALegHasGoneWhoseLeaningEdgeWasSeenAboveTheFloor) {
  for (const float wall : {inf, 4.5f}) {
    for (const std::size_t below : {20u, 60u, 112u, 150u, 200u, 222u}) {
      for (const std::size_t at : {202u, 203u}) {
        for (const bool left : {false, true}) {
          const Block leg = left ? too_near(at - 50, at) : too_near(at + 1, at + 50);
          begins(wall);
          EXPECT_EQ(sees({leg, column(at, below)}, below < 30 ? 2 : 1).speed, 0.0)
              << wall << ", " << below << ", " << at;
          EXPECT_EQ(sees({leg}, 20).speed, 0.0) << wall << ", " << below << ", " << at << ": the leg is there";
          EXPECT_EQ(sees({}, 10).speed, 0.2) << wall << ", " << below << ", " << at << ", " << left;
        }
      }
    }
  }
}

TEST_P(HiddenEdges, BagStaysWhenTheLegHasGoneBesideWhichItHung) {
  const Block leg = too_near(150, 203);
  begins();
  for (const float z : {0.6f, 0.5f, 0.42f}) sees({leg, column(203, 112, z, 30)}, 2);
  sees({leg, {203, 233, 0, 112, nan}, column(203, 112)});
  sees({leg, {203, 240, 0, 112, nan}});
  for (int i = 0; i < 60; ++i) ASSERT_EQ(sees({{203, 240, 0, 112, nan}}).speed, 0.0) << i;
}

TEST_P(HiddenEdges, CordThatWasSeenToHangStaysThoughALegStoodBesideItLast) {
  const Block leg = too_near(204, 250);
  begins();
  sees({column(202, 112, 0.42f, 2)}, 3);
  sees({leg, column(202, 112, 0.41f, 2)}, 3);
  sees({leg}, 3);
  for (int i = 0; i < 60; ++i) ASSERT_EQ(sees({}).speed, 0.0) << i;
}

TEST_P(HiddenEdges, RailStaysWhenTheLegHasGoneBesideWhichItWasSeenLast) {
  const Block leg = too_near(150, 203);
  begins();
  sees({leg, {203, 290, 60, 68, 0.42f}});
  sees({leg, {203, 290, 60, 68, 0.405f}});
  sees({leg}, 3);
  for (int i = 0; i < 60; ++i) ASSERT_EQ(sees({}).speed, 0.0) << i;
}

TEST_P(HiddenEdges, PostOfTwoCentimetresStaysUntilItGoesWhenTheLegBesideItHasGone) {
  const Block leg = too_near(150, 203), post = too_near(203, 217);
  begins();
  sees({leg, column(203, height, 0.41f, 14)}, 2);
  sees({leg, post, column(216, 112)}, 2);
  for (int i = 0; i < 60; ++i) ASSERT_EQ(sees({post}).speed, 0.0) << i;
  EXPECT_EQ(sees({}, 10).speed, 0.2);
}

TEST_P(HiddenEdges, CordAtABorderInWhichTheFloorIsNeverSeenStays) {
  for (const std::size_t border : {6u, 16u, 30u}) {
    shows_always(too_near(0, border));
    begins();
    sees({column(border, 112)}, 3);
    for (int i = 0; i < 40; ++i) ASSERT_EQ(sees({}).speed, 0.0) << border << ", " << i;
  }
}

TEST_P(HiddenEdges, RobotDrivesOnWhenALegHasLeftThePictureOfWhichASliverWasLeft) {
  begins();
  sees({column(250, height, 0.42f, 60)}, 3);
  EXPECT_EQ(sees({column(319, 90, 0.46f)}).speed, 0.0);
  EXPECT_EQ(sees({}, 10).speed, 0.2);
}

TEST_P(HiddenEdges, RobotDrivesOnWhenALegHasSwungBackIntoThePictureByASliver) {
  for (const int clouds_between : {1, 3, 8}) {
    begins();
    sees({column(250, height, 0.42f, 60)}, 3);
    sees({}, clouds_between);
    EXPECT_EQ(sees({column(319, 218, 0.46f)}).speed, 0.0);
    EXPECT_EQ(sees({}, 10).speed, 0.2) << clouds_between;
  }
}

TEST_P(HiddenEdges, CordThatComesIntoThePictureAtItsBorderLongAfterALegHasLeftStays) {
  begins();
  sees({column(250, height, 0.42f, 60)}, 3);
  sees({}, 12);
  sees({column(318, 112, 0.46f, 2)}, 3);
  for (int i = 0; i < 60; ++i) ASSERT_EQ(sees({}).speed, 0.0) << i;
}

TEST_P(HiddenEdges, RobotDrivesOnWhenALegHasLeftTheCorridorOfWhichASliverWasLeft) {
  begins();
  sees({column(0, height, 0.57f, 60)}, 3);
  sees({column(0, height, 0.59f, 16), column(0, 200, 0.57f, 16)});
  EXPECT_EQ(sees({}, 10).speed, 0.2);
}

TEST_P(HiddenEdges, BagStaysThatHungAndLeftThePictureButForASliver) {
  begins();
  sees({column(250, 112, 0.42f, 60)}, 3);
  sees({column(319, 90, 0.46f)});
  for (int i = 0; i < 60; ++i) ASSERT_EQ(sees({}).speed, 0.0) << i;
}

TEST_P(HiddenEdges, CordThatComesIntoThePictureAtItsBorderStaysThoughALegStoodFarFromIt) {
  const Block leg = column(60, height, 0.42f, 60);
  begins();
  sees({leg}, 3);
  sees({leg, column(318, 112, 0.42f, 2)}, 3);
  sees({leg}, 3);
  for (int i = 0; i < 60; ++i) ASSERT_EQ(sees({}).speed, 0.0) << i;
}

}  // namespace
}  // namespace safety_control_cloud
