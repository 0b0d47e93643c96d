// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "../sanitized.hpp"
#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

Board kerb(float z) { return {z, -0.4f, 0.4f, floor_y - 0.05f, floor_y}; }

/// An Astra, whose lowest rows look at floor that is too near for it: every stray there is lower than any floor.
TEST(StraysOnTheFloor, WhereItIsTooNearAreNoFloorBeforeAStep) {
  for (const double share : some_of<double>({0.01, 0.03, 0.1})) {
    Settings settings;
    settings.near_loss.blind_range = 0.75;
    settings.near_loss.distance = 0.95;
    Robot robot(settings);
    std::mt19937 random(3);
    const auto among_strays = [&](std::vector<Board> boards) {
      boards.push_back({3.0f, -9.0f, 9.0f, -9.0f, floor_y});  // or there were strays before it too
      Scene scene(std::move(boards));
      scene.blank_nearer_than(0.75f);
      return scene.stray(share, random, 0.75f);
    };
    for (int i = 0; i < 600; ++i) ASSERT_EQ(robot.sees(among_strays({})).speed, 0.2) << share << " after " << i;
    for (float z = 0.94f; z > 0.78f; z -= 0.01f) robot.sees(among_strays({kerb(z)}));
    for (int i = 0; i < 600; ++i)
      ASSERT_LT(robot.sees(among_strays({kerb(0.74f)})).speed, 0.2) << share << " after " << i;
    for (int i = 0; i < 10; ++i) robot.sees(among_strays({}));
    EXPECT_EQ(robot.sees(among_strays({})).speed, 0.2) << share << ": it has gone";
  }
}

}  // namespace
}  // namespace safety_control_cloud
