// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/command.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace safety_control_cloud {
namespace {

TEST(Command, IsScaledAsAWhole) {
  Command command;
  command.linear = {0.4, -0.2, 0.0};
  command.angular = {0.0, 0.0, 1.0};
  EXPECT_EQ(scaled(command, 0.5).linear[1], -0.1);
  EXPECT_EQ(scaled(command, 0.5).angular[2], 0.5);
  EXPECT_TRUE(stands(in_plane(scaled(command, std::nan("")))));
}

}  // namespace
}  // namespace safety_control_cloud
