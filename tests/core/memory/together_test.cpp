// SPDX-License-Identifier: BSD-3-Clause
// What goes out of sight together, side by side, at the picture's border, or while the camera looks elsewhere.
#include <gtest/gtest.h>

#include <cmath>

#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

const Board wall = {3.0f, -9.0f, 9.0f, -9.0f, 9.0f};

/// Looks as a Kinect does, which sees nothing nearer than 0.8 m, or as an Xtion does.
class Sensor {
 public:
  explicit Sensor(float blind) : blind_(blind), robot_(with(blind)) {}

  Decision sees(const std::vector<Board>& boards) {
    Scene scene(boards);
    scene.blank_nearer_than(blind_);
    return robot_.sees(scene);
  }
  /// Boards at a distance come nearer until they are too near.
  template <class Boards>
  Decision loses(Boards boards) {
    Decision decision;
    for (float z = blind_ + 0.12f; z > blind_ - 0.02f; z -= 0.01f) decision = sees(boards(z));
    return decision;
  }
  float blind() const { return blind_; }

 private:
  static Settings with(float blind) {
    Settings settings;
    settings.near_loss.blind_range = blind;
    return settings;
  }

  float blind_;
  Robot robot_;
};

TEST(Together, LargeThingThatIsTakenAwayTakesNoSmallOneBesideItAlong) {
  for (const float blind : {0.4f, 0.8f}) {
    for (const float width : {0.03f, 0.05f, 0.1f}) {
      Sensor sensor(blind);
      const auto small = [&](float z) { return Board{z, -0.1f - width, -0.1f, -0.15f, 0.05f}; };
      const auto large = [&](float z) { return Board{z, -0.1f, 0.25f, -0.15f, 0.1f}; };
      ASSERT_EQ(sensor.loses([&](float z) { return std::vector<Board>{large(z), small(z), wall}; }).speed, 0.0);
      for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(sensor.sees({small(blind - 0.02f), wall}).speed, 0.0) << blind << ", " << width << ", " << i;
      }
      Decision decision;
      for (int i = 0; i < 20; ++i) decision = sensor.sees({wall});
      EXPECT_EQ(decision.speed, 0.2) << blind << ", " << width << ": both have gone";
    }
  }
}

TEST(Together, RestThatNobodySeesIsNotBelievedAtItsOldPlace) {
  for (const float share : {0.16f, 0.2f, 0.3f, 0.5f}) {
    Sensor sensor(0.8f);
    const auto rest = [&](float z) { return Board{z, -0.2f, -0.2f + 0.4f * share, -0.2f, 0.1f}; };
    const auto other = [&](float z) { return Board{z, -0.2f + 0.4f * share, 0.2f, -0.2f, 0.1f}; };
    sensor.loses([&](float z) { return std::vector<Board>{rest(z), other(z), wall}; });
    for (int i = 0; i < 20; ++i) EXPECT_EQ(sensor.sees({rest(0.78f), wall}).speed, 0.0) << share << ", " << i;
  }
}

/// What covers the same pixels and is too near to return.
Board too_near(const Board& board) {
  const float shrunk = 0.35f / board.z;
  return {0.35f, shrunk * board.x_min, shrunk * board.x_max, shrunk * board.y_min, shrunk * board.y_max};
}

TEST(Together, WhatIsLostAltogetherCountsBeforeANearerOneThatIsLostInPart) {
  const Board thing = {0.57f, -0.2f, -0.05f, -0.2f, 0.1f}, nearer = {0.53f, 0.05f, 0.22f, -0.2f, 0.1f};
  Board part = nearer;
  part.x_min = 0.15f;
  for (const bool other_too : {false, true}) {
    Robot robot;
    for (int i = 0; i < 5; ++i) robot.sees({thing, nearer, wall});
    std::vector<Board> now = {nearer, too_near(part), wall};
    now.push_back(other_too ? too_near(thing) : thing);
    for (int i = 0; i < 20; ++i) {
      EXPECT_EQ(robot.sees(now).speed, other_too ? 0.0 : 0.1) << i << ": a part is where the rest is seen";
    }
  }
}

TEST(Together, OneOfTwoLikePolesIsNotTakenForTheOther) {
  for (const float behind : {0.07f, 0.08f, 0.1f}) {
    Sensor sensor(0.8f);
    const auto poles = [&](float z) {
      return std::vector<Board>{{z, -0.12f, -0.06f, -0.2f, 0.1f}, {z + behind, 0.0f, 0.06f, -0.2f, 0.1f}, wall};
    };
    sensor.loses(poles);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(sensor.sees(poles(0.76f)).speed, 0.0) << behind << ", " << i;
  }
}

TEST(Together, EdgeThatLeavesThePictureAtItsTopIsStillThere) {
  for (const float edge : {-0.24f, -0.22f, -0.2f}) {
    Robot robot;
    Decision decision;
    for (float z = 0.9f; z > 0.3f; z -= 0.01f) decision = robot.sees({{z, -0.6f, 0.6f, -1.0f, edge}, wall});
    EXPECT_EQ(decision.speed, 0.0) << edge;
  }
}

TEST(Together, FewFalsePixelsInOneCloudAreForgotten) {
  Robot robot;
  for (int i = 0; i < 10; ++i) robot.sees(Scene());
  Scene scene;
  for (const std::size_t row : {40, 41}) {
    for (const std::size_t column : {80, 81}) scene.set(row, column, 0.6f);
  }
  robot.sees(scene);
  Decision decision;
  for (int i = 0; i < 10; ++i) decision = robot.sees(Scene());
  EXPECT_EQ(decision.speed, 0.2);
}

/// A sliver of what moves fast at the corridor's side; a static thing is seen again and again.
TEST(Together, LittleThatIsSeenInOneCloudAloneIsForgotten) {
  struct Block {
    std::size_t rows, columns;
    float z;
  };
  const Scene hall, before_a_wall({wall});
  for (const Scene* behind : {&hall, &before_a_wall}) {
    for (const Block& block : {Block{2, 2, 0.6f}, Block{9, 2, 0.6f}, Block{4, 9, 0.45f}, Block{3, 12, 0.41f}}) {
      for (const int clouds : {1, 2}) {
        Robot robot;
        for (int i = 0; i < 10; ++i) robot.sees(*behind);
        Scene scene = *behind;
        for (std::size_t i = 0; i < block.rows * block.columns; ++i)
          scene.set(2 + i / block.columns, 75 + i % block.columns, block.z);
        for (int i = 0; i < clouds; ++i) robot.sees(scene);
        Decision decision;
        for (int i = 0; i < 10; ++i) decision = robot.sees(*behind);
        EXPECT_EQ(decision.speed > 0.0, clouds == 1) << block.rows << " rows of " << block.columns << ", " << clouds;
      }
    }
  }
}

Placement panned(float angle) {
  Placement place;
  place.rows = {{{std::cos(angle), 0, std::sin(angle), 0}, {0, 1, 0, 0}, {-std::sin(angle), 0, std::cos(angle), 0}}};
  return place;
}

/// What is 0.38 m ahead and 0.2 m wide, before a camera that looks so far to the right.
Board seen_aside(float angle) {
  const auto slant = [=](float x) {
    return (x * std::cos(angle) - 0.38f * std::sin(angle)) / (x * std::sin(angle) + 0.38f * std::cos(angle));
  };
  return {0.3f, 0.3f * slant(-0.1f), 0.3f * slant(0.1f), -0.15f, 0.08f};
}

TEST(Together, CameraThatLooksElsewhereDoesNotSeeThatWhatIsLostHasGone) {
  Settings settings;
  settings.target_frame = "base_link";
  for (const float angle : {0.15f, 0.3f, 0.45f}) {
    SafetyControl control(settings);
    double now = 100.0;
    const auto sees = [&](const Scene& scene, float pan) {
      now += 0.05;
      return control.decide(scene.view(), Origin{now, panned(pan)}, Instant{now, now});
    };
    const Scene near({{0.45f, -0.1f, 0.1f, -0.2f, 0.1f}, wall}), blind({{0.38f, -0.1f, 0.1f, -0.2f, 0.1f}, wall});
    const Scene aside({seen_aside(angle), wall});
    for (int i = 0; i < 5; ++i) sees(near, 0.0f);
    sees(blind, 0.0f);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(sees(aside, angle).speed, 0.0) << angle << ", " << i;
    for (int i = 0; i < 10; ++i) EXPECT_EQ(sees(blind, 0.0f).speed, 0.0) << angle << ", " << i;
    Decision decision;
    for (int i = 0; i < 20; ++i) decision = sees(Scene({wall}), 0.0f);
    EXPECT_EQ(decision.speed, 0.2) << angle;
  }
}

}  // namespace
}  // namespace safety_control_cloud
