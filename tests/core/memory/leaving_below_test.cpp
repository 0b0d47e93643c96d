// SPDX-License-Identifier: BSD-3-Clause
// What stands in the corridor and leaves the picture at its lower border, beyond the blind range: a camera that looks
// level from higher up, or whose picture is wide and low, looks over it.
#include <gtest/gtest.h>

#include <vector>

#include "lens.hpp"
#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

/// A wide and low picture, whose lower border leaves the corridor 0.92 m before the camera.
const Lens low = Lens().part(0, 30, 160, 60);

const Board behind = {3.0f, -9.0f, 9.0f, -9.0f, floor_y};

/// From its front on, so deep [m].
std::vector<Board> box(float front, float height, float depth) {
  std::vector<Board> boards{behind};
  for (float z = front; z <= front + depth; z += 0.004f) boards.push_back({z, -0.2f, 0.2f, floor_y - height, floor_y});
  return boards;
}

struct RobotWithLowPicture : Robot {
  Decision looks(const std::vector<Board>& boards) {
    const auto points = low.points(boards);
    return sees(low.view_of_rows(points));
  }

  /// A box comes nearer, 1 cm a cloud; where its front is as the robot stands, or 0 [m].
  float stops_before(float height, float depth) {
    for (float front = 1.3f; front > 0.0f; front -= 0.01f)
      if (looks(box(front, height, depth)).speed == 0.0) return front;
    return 0.0f;
  }
};

TEST(LeavingBelow, WhatIsLookedOverIsNotSeenToGo) {
  for (const float height : {0.12f, 0.14f, 0.16f, 0.18f}) {
    const float leaves_at = (floor_y - height) / 0.2165f;  // [m]
    for (const float depth : {0.0f, 0.02f, 0.05f, 0.3f}) {
      RobotWithLowPicture robot;
      EXPECT_GT(robot.stops_before(height, depth), leaves_at - depth - 0.05f)
          << height << " high, " << depth << " deep";
    }
  }
}

TEST(LeavingBelow, ItStaysHoweverLongNothingOfItIsSeen) {
  RobotWithLowPicture robot;
  ASSERT_GT(robot.stops_before(0.16f, 0.0f), 0.5f);
  for (int i = 0; i < 400; ++i) ASSERT_EQ(robot.looks({behind}).speed, 0.0) << i;
  robot.control().forget_losses();
  EXPECT_EQ(robot.looks({behind}).speed, 0.2) << "somebody has looked";
}

TEST(LeavingBelow, WhatIsTakenAwayFromTheMiddleOfThePictureHasGone) {
  RobotWithLowPicture robot;
  for (float front = 1.0f; front > 0.6f; front -= 0.01f) robot.looks(box(front, 0.35f, 0.1f));
  for (int i = 0; i < 5; ++i) robot.looks({behind});
  EXPECT_EQ(robot.looks({behind}).speed, 0.2);
}

TEST(LeavingBelow, SomebodyWhoCrossesHasGone) {
  RobotWithLowPicture robot;
  for (float x = -0.8f; x < 0.8f; x += 0.04f) robot.looks({behind, post(0.7f, x, 0.12f)});
  for (int i = 0; i < 5; ++i) robot.looks({behind});
  EXPECT_EQ(robot.looks({behind}).speed, 0.2);
}

/// Nobody looked for a while, in which the robot rolled on: what the picture before showed was farther from its border.
TEST(LeavingBelow, ItMayHaveLeftInAPauseOfTheCamera) {
  const Lens lens;
  constexpr float height = 0.11f, leaves_at = (floor_y - height) / 0.4294f;  // [m]
  for (const double pause : {0.3, 0.7, 3.0}) {
    Robot robot;
    const auto looks = [&](float front) {
      const auto points = lens.points(box(front, height, 0.0f));
      return robot.sees(lens.view_of_rows(points));
    };
    for (float front = leaves_at + 0.5f; front > leaves_at + 0.08f; front -= 0.01f) looks(front);
    robot.waits(pause);
    for (int i = 0; i < 100; ++i) looks(leaves_at - 0.01f);
    EXPECT_EQ(looks(leaves_at - 0.01f).speed, 0.0) << pause;
    robot.control().forget_losses();
    EXPECT_EQ(looks(leaves_at - 0.01f).speed, 0.2) << "somebody has looked";
  }
}

TEST(LeavingBelow, SomebodyWhoLeavesInAPauseHasGone) {
  for (const float ahead : {0.6f, 0.8f, 1.0f}) {
    RobotWithLowPicture robot;
    for (int i = 0; i < 20; ++i) robot.looks({behind, post(ahead, 0.0f, 0.12f)});
    robot.waits(1.0);
    for (int i = 0; i < 10; ++i) robot.looks({behind});
    EXPECT_EQ(robot.looks({behind}).speed, 0.2) << ahead;
  }
}

TEST(LeavingBelow, AWallThatReachesBelowThePictureIsAsFarAsItIsSeen) {
  RobotWithLowPicture robot;
  for (float z = 1.5f; z > 0.51f; z -= 0.01f)
    EXPECT_GT(robot.looks({{z, -9.0f, 9.0f, -9.0f, floor_y}}).speed, 0.0) << z;
}

}  // namespace
}  // namespace safety_control_cloud
