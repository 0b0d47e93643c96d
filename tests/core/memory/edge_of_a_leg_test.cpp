// SPDX-License-Identifier: BSD-3-Clause
// What is so thin in the picture that the rows and columns which are read may miss it.
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "../sanitized.hpp"
#include "standing_beside.hpp"

namespace safety_control_cloud {
namespace {

/// The hall as a sensor of twice the resolution has it, and of a leg just the edge of which is not too near.
struct EdgeOfALeg {
  static constexpr std::size_t width = 2 * Scene::width, height = 2 * Scene::height;

  explicit EdgeOfALeg(std::optional<std::size_t> column) : points(width * height) {
    const Scene hall;
    const auto* const seen = reinterpret_cast<const Xyz*>(hall.view().bytes);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = seen[i / width / 2 * Scene::width + i % width / 2];
    for (std::size_t row = 0; column && row < height; ++row) {
      const float right = (static_cast<float>(*column) - 159.5f) / 277.0f,
                  down = (static_cast<float>(row) - 119.5f) / 277.0f;
      points[row * width + *column] = {0.401f * right, 0.401f * down, 0.401f};
    }
  }

  CloudView view() const {
    CloudView view = view_of(points);
    view.width = width, view.height = height, view.row_step = width * sizeof(Xyz);
    return view;
  }

  std::vector<Xyz> points;
};

TEST(NearLoss, RobotDrivesOnWhenALegHasGoneOfWhichOnlyAnEdgeWasSeenLast) {
  for (const std::size_t column : {160u, 161u, 264u, 265u}) {
    Robot robot;
    robot.sees(EdgeOfALeg(std::nullopt).view());
    EXPECT_EQ(robot.sees(EdgeOfALeg(column).view()).speed, 0.0) << column;
    EXPECT_EQ(robot.sees(EdgeOfALeg(std::nullopt).view()).speed, 0.2) << column;
  }
}

class Edges : public StandingBeside {};
INSTANTIATE_TEST_SUITE_P(Strays, Edges, testing::ValuesIn(some_of<double>({0.0, 0.001, 0.01, 0.1})));

TEST_P(Edges, RobotDrivesOnWhenALegHasGoneOfWhoseLeaningEdgeASliverWasSeenLast) {
  const Block hidden = too_near(150, 203);
  for (const std::size_t foot : {60u, 112u}) {
    for (const std::size_t at : {202u, 203u, 204u}) {  // at 202 it hides the floor below itself
      begins();
      for (const float z : {0.6f, 0.5f, 0.42f}) sees({leg(150, 203, z)}, 2);
      sees({hidden, column(at, foot)});
      sees({hidden}, 5);
      EXPECT_EQ(sees({}, 10).speed, 0.2) << foot << ", " << at;
    }
  }
}

TEST_P(Edges, RobotDrivesOnWhenALegHasGoneOfWhichASliverCameBackIntoView) {
  begins();
  for (const float z : {0.6f, 0.5f, 0.42f}) sees({leg(150, 203, z)}, 2);
  sees({too_near(150, 203)}, 5);
  sees({too_near(142, 195), column(142, 60, 0.401f)}, 2);
  sees({too_near(110, 160)}, 2);
  EXPECT_EQ(sees({}, 10).speed, 0.2);
}

/// Of which the lower part is beside the corridor already, that ends at column 19.
TEST_P(Edges, RobotDrivesOnWhenALegHasGoneThatLeanedOutOfTheCorridorBehindAnother) {
  begins();
  sees({leg(0, 24, 0.62f), leg(24, 70, 0.49f)}, 2);
  sees({leg(0, 22, 0.59f), {0, 22, 215, height, 0.6f}, leg(22, 60, 0.48f)});
  sees({leg(0, 50, 0.47f)}, 3);
  EXPECT_EQ(sees({}, 10).speed, 0.2);
}

TEST_P(Edges, SliverStaysBesideALegIfItWasSeenToHangBeforeOrIsMoreThanAnEdge) {
  const Block hidden = too_near(150, 203);
  for (const std::size_t columns : {3u, 6u}) {
    begins();
    for (const float z : {0.6f, 0.5f, 0.42f}) sees({leg(150, 203, z)}, 2);
    sees({hidden, column(204, 112, 0.408f, columns)}, 2);
    sees({hidden}, 3);
    stands_for_good();
  }
}

/// The corridor ends at column 24.
TEST_P(Edges, BoardStaysThatReachesIntoTheCorridorByAnEdgeBesideALeg) {
  for (const std::size_t to : {25u, 26u, 28u}) {
    const Block board = {0, to, 0, 112, 0.61f}, board_too_near = {0, to, 0, 112, nan};
    begins();
    for (const float z : {0.6f, 0.56f, 0.52f}) sees({leg(to, 70, z)}, 2);
    sees({too_near(to, 70), board}, 2);
    sees({too_near(to, 70), board_too_near}, 3);
    stands_for_good({board_too_near});
  }
}

}  // namespace
}  // namespace safety_control_cloud
