// SPDX-License-Identifier: BSD-3-Clause
// near_loss_timeout: each of several losses is forgotten by its own time.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

constexpr double timeout = 5.0;

Settings impatient() {
  Settings settings;
  settings.near_loss.timeout = timeout;
  return settings;
}

double fastest_in(double seconds, Robot& robot, const Scene& scene) {
  double fastest = 0.0;
  for (double at = 0.0; at < seconds; at += 0.05) fastest = std::max(fastest, robot.sees(scene).speed);
  return fastest;
}

struct Case {
  bool organised, wall_behind;
};

class Timeout : public testing::TestWithParam<Case> {
 protected:
  Decision sees(std::vector<Board> boards) {
    if (GetParam().wall_behind) boards.push_back({3.0f, -9.0f, 9.0f, -9.0f, floor_y});
    const Scene scene(boards);
    if (GetParam().organised) return robot_.sees(scene);
    const auto points = scene.returns();
    return robot_.sees(view_of(points));
  }
  /// For so long; the fastest that it drove.
  double fastest_in(double seconds, const std::vector<Board>& boards) {
    double fastest = 0.0;
    for (double at = 0.0; at < seconds; at += 0.05) fastest = std::max(fastest, sees(boards).speed);
    return fastest;
  }

 private:
  Robot robot_{impatient()};
};
INSTANTIATE_TEST_SUITE_P(Of, Timeout,
                         testing::Values(Case{true, false}, Case{true, true}, Case{false, false}, Case{false, true}),
                         [](const auto& info) {
                           return std::string(info.param.organised ? "Picture" : "Points") +
                                  (info.param.wall_behind ? "BeforeAWall" : "InAHall");
                         });

Board left(float z) { return {z, -0.15f, -0.05f, -0.15f, 0.0f}; }
Board right(float z) { return {z, 0.05f, 0.2f, -0.15f, 0.02f}; }

TEST_P(Timeout, WhatWasLostAMomentAgoIsNotForgottenWithWhatWasLostLongAgo) {
  for (float z = 0.6f; z > 0.37f; z -= 0.01f) sees({left(z)});
  EXPECT_EQ(fastest_in(timeout - 0.6, {left(0.37f)}), 0.0);
  for (float z = 0.6f; z > 0.37f; z -= 0.04f) sees({left(0.37f), right(z)});
  EXPECT_EQ(fastest_in(timeout - 0.3, {left(0.37f), right(0.37f)}), 0.0);
  EXPECT_EQ(fastest_in(0.5, {left(0.37f), right(0.37f)}), 0.2) << "by now it has been lost for as long";
}

TEST_P(Timeout, WhatIsSeenForLongerThanAPartOfItIsRememberedForLonger) {
  const Board seen = {0.5f, -0.2f, 0.0f, -0.15f, 0.0f}, part = {0.5f, 0.0f, 0.2f, -0.15f, 0.0f};
  const Board blind_part = {0.37f, 0.0f, 0.148f, -0.111f, 0.0f};
  for (int i = 0; i < 5; ++i) sees({seen, part});
  fastest_in(timeout - 0.5, {seen, blind_part});
  const Board blind = {0.37f, -0.148f, 0.148f, -0.111f, 0.0f};
  EXPECT_EQ(fastest_in(timeout - 0.3, {blind}), 0.0);
}

TEST(TimeoutOf, AThingTakesNoKerbAlongAndAKerbNoOther) {
  const Board high = {0.5f, 0.1f, 0.2f, -0.15f, 0.0f};
  const auto kerb = [](float z, float x) { return Board{z, x, x + 0.15f, 0.22f, floor_y}; };
  Robot robot(impatient());
  const auto comes = [&](float x, const std::vector<Board>& others) {
    for (float z = 0.74f; z > 0.6f; z -= 0.02f) {
      auto boards = others;
      boards.push_back(kerb(z, x));
      robot.sees(boards);
    }
  };
  for (int i = 0; i < 5; ++i) robot.sees({high});
  EXPECT_EQ(fastest_in(timeout / 2, robot, Scene()), 0.0) << "the thing is lost";
  comes(-0.25f, {});
  const Board first = kerb(0.62f, -0.25f), second = kerb(0.62f, 0.05f);
  EXPECT_EQ(fastest_in(timeout - 0.5, robot, Scene(std::vector<Board>{first})), 0.0)
      << "the thing is forgotten meanwhile, the kerb is not";
  comes(0.05f, {first});
  EXPECT_EQ(fastest_in(timeout - 0.5, robot, Scene({first, second})), 0.0) << "the first kerb is forgotten meanwhile";
}

/// What lies on the floor from z on, as deep as the camera sees.
Scene with_plateau(float z) {
  std::vector<Board> boards;
  for (float behind = z; behind < 0.9f; behind += 0.005f)
    boards.push_back({behind, -0.2f, 0.2f, floor_y - 0.05f, floor_y});
  return Scene(boards);
}

TEST(TimeoutOf, AStepBeforeWhichTheFloorIsNotSeenAgain) {
  Robot robot(impatient());
  for (float z = 0.74f; z > 0.5f; z -= 0.01f) robot.sees(with_plateau(z));
  EXPECT_EQ(fastest_in(timeout - 1.0, robot, with_plateau(0.5f)), 0.0);
  EXPECT_EQ(fastest_in(1.1, robot, with_plateau(0.5f)), 0.2);
}

/// Beside the picture's floor on one side only: a gap between floor and floor hides something whatever was seen before.
TEST(TimeoutOf, FloorThatIsHiddenAtOneSideOfThePictureTakesNotTheOtherSideAlong) {
  const Board at_left = {0.36f, -0.3f, -0.185f, -1.0f, floor_y}, at_right = {0.36f, 0.185f, 0.3f, -1.0f, floor_y};
  Robot robot(impatient());
  for (int i = 0; i < 10; ++i) robot.sees(Scene());
  EXPECT_EQ(fastest_in(timeout - 0.5, robot, Scene(std::vector<Board>{at_left})), 0.0);
  EXPECT_EQ(fastest_in(timeout - 0.3, robot, Scene({at_left, at_right})), 0.0)
      << "the left side is forgotten meanwhile";
  EXPECT_EQ(fastest_in(0.6, robot, Scene({at_left, at_right})), 0.2);
}

}  // namespace
}  // namespace safety_control_cloud
