// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/command/other_commanders.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

std::string reason_of(const std::optional<Doubt>& doubt) { return doubt ? doubt->reason : ""; }

TEST(OtherCommanders, NobodyElseIsNoDoubt) { EXPECT_FALSE(OtherCommanders("/cmd_vel").doubt(10.0)); }

TEST(OtherCommanders, WhoeverWasHeardIsNamedUntilASecondOfSilence) {
  OtherCommanders others("/cmd_vel");
  others.heard("/teleop", 10.0);
  EXPECT_EQ(others.doubt(10.9)->cause, Cause::TwoCommanders);
  EXPECT_EQ(reason_of(others.doubt(10.9)), "/teleop commands the robot on /cmd_vel");
  EXPECT_FALSE(others.doubt(11.1));
}

TEST(OtherCommanders, WhoSpeaksSeldomHasNotGoneBetweenTwoWords) {
  OtherCommanders others("/cmd_vel");
  for (double now = 10.0; now < 30.0; now += 3.0) others.heard("/slow", now);
  EXPECT_TRUE(others.doubt(28.0 + 5.9));
  EXPECT_FALSE(others.doubt(28.0 + 6.1));
}

TEST(OtherCommanders, WhoIsConnectedIsADoubtBeforeItSaysAnything) {
  OtherCommanders others("/cmd_vel");
  others.connected({"/teleop", "/bag"});
  EXPECT_EQ(reason_of(others.doubt(1e6)), "/bag, /teleop is about to command the robot on /cmd_vel");
  others.heard("/teleop", 1e6);
  EXPECT_EQ(reason_of(others.doubt(1e6)), "/teleop commands the robot on /cmd_vel");
  others.connected({});
  EXPECT_FALSE(others.doubt(1e6 + 1.1));
}

}  // namespace
}  // namespace safety_control_cloud
