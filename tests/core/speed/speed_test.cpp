// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/speed/speed.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

TEST(Speed, TutorialSpeedsAreTheDefaults) {
  EXPECT_EQ(speed_for(Zone::Safe, {}), 0.2);
  EXPECT_EQ(speed_for(Zone::Warning, {}), 0.1);
  EXPECT_EQ(speed_for(Zone::Danger, {}), 0.0);
}

TEST(Speed, DangerIsStandingWhateverTheSpeeds) { EXPECT_EQ(speed_for(Zone::Danger, {5.0, 4.0}), 0.0); }

TEST(Speed, ZoneThatDoesNotExistIsStanding) { EXPECT_EQ(speed_for(static_cast<Zone>(7), {}), 0.0); }

}  // namespace
}  // namespace safety_control_cloud
