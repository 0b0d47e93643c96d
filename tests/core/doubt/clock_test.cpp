// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/doubt/clock.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

TEST(ClockWatch, TimeThatGoesOnIsNoDoubt) {
  ClockWatch clock;
  for (const double now : {1.0, 1.0, 1.05, 1e9}) EXPECT_FALSE(clock.note(now)) << now;
}

TEST(ClockWatch, AStepBackByWhichClocksAreSetRightIsNone) {
  ClockWatch clock;
  clock.note(100.0);
  EXPECT_FALSE(clock.note(99.91));
  const auto doubt = clock.note(99.8);
  ASSERT_TRUE(doubt);
  EXPECT_EQ(doubt->cause, Cause::ClockJump);
}

TEST(ClockWatch, AfterAJumpTheNewTimeCounts) {
  ClockWatch clock;
  clock.note(100.0);
  EXPECT_TRUE(clock.note(5.0));
  EXPECT_FALSE(clock.note(5.1));
}

TEST(ClockWatch, ZeroIsNoTimeAndNoJumpEither) {
  ClockWatch clock;
  clock.note(100.0);
  EXPECT_EQ(clock.note(0.0)->cause, Cause::NoTime);
  EXPECT_FALSE(clock.note(100.1));
}

}  // namespace
}  // namespace safety_control_cloud
