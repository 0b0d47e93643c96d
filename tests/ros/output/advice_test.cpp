// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/output/advice.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

const std::string node = "/robot/guard";
constexpr double months = 1e7;  ///< [s]

bool speaks_of(const std::string& advice, const std::string& words) { return advice.find(words) != std::string::npos; }

TEST(Advice, WhoStandsForSomethingThatWentIsToldTheWayOut) {
  EXPECT_TRUE(speaks_of(advice_for(Cause::NearLoss, 0.0, node), "rosservice call /robot/guard/reset"));
}

TEST(Advice, AStampOfMonthsAgoIsARecordingsAndTheNodeHasToStartAnew) {
  for (const Cause cause : {Cause::Stale, Cause::Future}) {
    const std::string advice = advice_for(cause, cause == Cause::Stale ? months : -months, node);
    EXPECT_TRUE(speaks_of(advice, "rosbag play --clock, and start this node anew")) << advice;
    EXPECT_TRUE(speaks_of(advice, "stamp_tolerance 0")) << advice;
  }
}

TEST(Advice, ACameraThatIsSecondsLateIsNoRecording) { EXPECT_EQ(advice_for(Cause::Stale, 3.0, node), ""); }

TEST(Advice, WhoDrivesNeedsNone) { EXPECT_EQ(advice_for(Cause::Seen, months, node), ""); }

}  // namespace
}  // namespace safety_control_cloud
