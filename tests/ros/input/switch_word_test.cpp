// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/input/switch_word.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace safety_control_cloud {
namespace {

TEST(SwitchWord, OfABoolIsWhetherItIsTouchedAndNoSide) {
  EXPECT_TRUE(word_in("std_msgs/Bool", {1}).touched);
  EXPECT_FALSE(word_in("std_msgs/Bool", {0}).touched);
  EXPECT_EQ(word_in("std_msgs/Bool", {1}).side, std::nullopt);
}

/// kobuki_msgs: LEFT 0, CENTER 1, RIGHT 2; PRESSED 1; CLIFF 1, and then the sensor's raw uint16.
TEST(SwitchWord, OfAKobukiSaysItsSide) {
  const SwitchWord left = word_in("kobuki_msgs/BumperEvent", {0, 1}),
                   center = word_in("kobuki_msgs/BumperEvent", {1, 0});
  EXPECT_EQ(left.side, Edge::FrontLeft);
  EXPECT_TRUE(left.touched);
  EXPECT_EQ(center.side, Edge::Front);
  EXPECT_FALSE(center.touched);
  const SwitchWord cliff = word_in("kobuki_msgs/CliffEvent", {2, 1, 0xff, 0x01});
  EXPECT_EQ(cliff.side, Edge::FrontRight);
  EXPECT_TRUE(cliff.touched);
}

TEST(SwitchWord, OfAnyOtherMessageIsNone) {
  EXPECT_THROW(word_in("std_msgs/Int8", {1}), std::invalid_argument);
  EXPECT_THROW(word_in("std_msgs/Bool", {}), std::invalid_argument);
  EXPECT_THROW(word_in("kobuki_msgs/BumperEvent", {3, 1}), std::invalid_argument);
  EXPECT_THROW(word_in("kobuki_msgs/BumperEvent", {0, 1, 0, 0}), std::invalid_argument);
  EXPECT_THROW(word_in("kobuki_msgs/CliffEvent", {0, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace safety_control_cloud
