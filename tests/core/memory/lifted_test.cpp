// SPDX-License-Identifier: BSD-3-Clause
// What stood on the floor, is lifted while it is seen and then comes too near to be seen.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "../sanitized.hpp"
#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

/// Its lower end is so much above the floor [m].
struct Crate {
  float left, right, top;

  Board at(float z, float lifted) const { return {z, left, right, top - lifted, floor_y - lifted}; }
};

const std::vector<Crate> crates = some_of<Crate>({{-0.35f, 0.35f, -1.0f},
                                                  {-0.35f, 0.35f, -0.05f},
                                                  {-0.1f, 0.1f, 0.0f},
                                                  {-0.3f, 0.05f, -0.3f},
                                                  {0.15f, 0.4f, -0.1f},
                                                  {0.0f, 0.06f, -1.0f},
                                                  {-0.15f, 0.15f, 0.0f}});

struct Case {
  bool organised, wall_behind;
};

class Lifted : public testing::TestWithParam<Case> {
 protected:
  Decision sees(std::vector<Board> boards, float farthest = 5.0f) {
    if (GetParam().wall_behind) boards.push_back({2.5f, -9.0f, 9.0f, -9.0f, floor_y});
    Scene scene = Scene(boards).drop(0.1, random_);
    scene.blank_farther_than(farthest);
    if (GetParam().organised) return robot_.sees(scene);
    const auto points = scene.returns();
    return robot_.sees(view_of(points));
  }
  void comes(const Crate& crate, float stands_at) {
    robot_ = Robot();
    for (int i = 0; i < 10; ++i) sees({});
    for (float z = 0.8f; z > stands_at; z -= 0.02f) sees({crate.at(z, 0.0f)});
  }
  void is_lifted(const Crate& crate, float z, float by) {
    for (float lifted = 0.0f; lifted < by; lifted += 0.02f) sees({crate.at(z, lifted)});
    for (int i = 0; i < 5; ++i) sees({crate.at(z, by)});
  }

 private:
  std::mt19937 random_{3};
  Robot robot_;
};
INSTANTIATE_TEST_SUITE_P(Seen, Lifted,
                         testing::Values(Case{true, false}, Case{true, true}, Case{false, false}, Case{false, true}),
                         [](const auto& info) {
                           return std::string(info.param.organised ? "Picture" : "Points") +
                                  (info.param.wall_behind ? "BeforeAWall" : "InAHall");
                         });

TEST_P(Lifted, FloorThatIsSeenBelowItAllTheTimeDoesNotFreeIt) {
  for (const Crate& crate : crates) {
    for (const float stands_at : {0.45f, 0.5f, 0.6f}) {
      for (const float by : {0.16f, 0.2f}) {
        comes(crate, stands_at);
        is_lifted(crate, stands_at, by);
        for (float z = stands_at; z > 0.37f; z -= 0.02f) sees({crate.at(z, by)});
        for (int i = 0; i < 40; ++i) {
          ASSERT_EQ(sees({crate.at(0.37f, by)}).speed, 0.0)
              << crate.left << ", " << crate.top << " at " << stands_at << " by " << by << " after " << i;
        }
      }
    }
  }
}

TEST_P(Lifted, WhatIsSetDownAgainAndGoesAsideIsNotLost) {
  for (const Crate& crate : crates) {
    comes(crate, 0.5f);
    is_lifted(crate, 0.5f, 0.16f);
    for (float lifted = 0.16f; lifted > 0.0f; lifted -= 0.02f) sees({crate.at(0.5f, lifted)});
    for (float aside = 0.0f; aside < 1.0f; aside += 0.03f)
      sees({Crate{crate.left + aside, crate.right + aside, crate.top}.at(0.5f, 0.0f)});
    Decision decision;
    for (int i = 0; i < 60; ++i) decision = sees({});
    EXPECT_EQ(decision.speed, 0.2) << crate.left << ", " << crate.top;
  }
}

TEST_P(Lifted, FloorThatReturnsNothingWhileItComesNearerDoesNotFreeIt) {
  for (const float farthest : {0.6f, 0.76f}) {  // no floor at all, and the nearest before it
    for (const Crate& crate : crates) {
      comes(crate, 0.5f);
      is_lifted(crate, 0.5f, 0.2f);
      for (float z = 0.5f; z > 0.37f; z -= 0.02f) sees({crate.at(z, 0.2f)}, farthest);
      for (int i = 0; i < 40; ++i) {
        ASSERT_EQ(sees({crate.at(0.37f, 0.2f)}).speed, 0.0) << crate.left << " beyond " << farthest << " after " << i;
      }
    }
  }
}

TEST_P(Lifted, LidStaysLostWhenWhatItLayOnIsTakenAway) {
  const auto lid = [](float z) { return Board{z, -0.4f, 0.4f, -0.2f, 0.0f}; };
  const auto below = [](float z) { return Board{z, -0.1f, 0.4f, 0.0f, floor_y}; };
  for (float z = 0.8f; z > 0.37f; z -= 0.02f) sees({lid(z), below(z)});
  for (int i = 0; i < 10; ++i) ASSERT_EQ(sees({lid(0.37f), below(0.37f)}).speed, 0.0) << i;
  for (int i = 0; i < 40; ++i) ASSERT_EQ(sees({lid(0.37f)}).speed, 0.0) << i;
}

/// In the picture the corridor's side leans then: of what leaves the corridor the upper end is the last that is in it.
TEST(Stood, PostThatIsSeenToLeaveACorridorInWhichTheCameraIsRolledIsNotLost) {
  Settings settings;
  settings.target_frame = "base_link";
  for (const float roll : {-0.12f, -0.1f, -0.08f, 0.08f, 0.1f, 0.12f}) {
    Placement place;
    place.rows = {
        {{std::cos(roll), std::sin(roll), 0, 0}, {-std::sin(roll), std::cos(roll), 0, -floor_y}, {0, 0, 1, 0}}};
    for (const float side : {-1.0f, 1.0f}) {
      Robot robot(settings, place);
      for (int i = 0; i < 10; ++i) robot.sees(Scene());
      for (float x = 0.0f; x < 1.0f; x += 0.01f) robot.sees({post(0.5f, side * x, 0.1f)});
      Decision decision;
      for (int i = 0; i < 20; ++i) decision = robot.sees(Scene());
      EXPECT_EQ(decision.speed, 0.2) << roll << ", " << side;
    }
  }
}

}  // namespace
}  // namespace safety_control_cloud
