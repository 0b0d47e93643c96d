// SPDX-License-Identifier: BSD-3-Clause
// What is so thin in the picture that the rows and columns which are read may miss it.
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "looking_robot.hpp"

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

}  // namespace
}  // namespace safety_control_cloud
