// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/doubt/sources.hpp"

#include <gtest/gtest.h>

#include "../../../safety_control_cloud/core/safety_control.hpp"
#include "../input/cloud_builder.hpp"

namespace safety_control_cloud {
namespace {

/// Of the decision for a free corridor that `source` has seen.
Cause cause_of(const char* source, double now, SafetyControl& control) {
  const std::vector<Xyz> far = {{0.0f, 0.0f, 3.0f}};
  return control.decide(view_of(far), Origin{now, OpticalFrame{}, source}, Instant{now, now}).cause;
}

TEST(Sources, RobotStandsWhileTwoSourcesTakeTurns) {
  SafetyControl control{Settings{}};
  const auto sent_by = [&](const char* source, double now) { return cause_of(source, now, control); };
  EXPECT_EQ(sent_by("camera", 1.00), Cause::Seen);
  EXPECT_EQ(sent_by("bag", 1.02), Cause::TwoSources);
  EXPECT_EQ(sent_by("camera", 1.05), Cause::TwoSources);
  EXPECT_EQ(sent_by("camera", 1.10), Cause::TwoSources) << "the other's next cloud may be under way";
  EXPECT_EQ(sent_by("camera", 1.60), Cause::Seen);
  EXPECT_EQ(sent_by("camera started anew", 2.20), Cause::TwoSources) << "the old one's last took as long";
  EXPECT_EQ(sent_by("camera started anew", 2.70), Cause::Seen) << "the old one counts as silent";
}

TEST(Sources, SourceThatSendsOnceASecondBesideTheCameraDoesNotLetTheRobotGoAndStop) {
  SafetyControl control{Settings{}};
  const auto cause_at = [&](const char* source, double now) { return cause_of(source, now, control); };
  constexpr double start = 100.0, period = 0.05;
  for (int cloud = 0; cloud < 100; ++cloud) {
    const double now = start + cloud * period;
    const Cause cause = cause_at("camera", now);
    if (now > start + 1.1) {
      EXPECT_EQ(cause, Cause::TwoSources) << now - start;
    }
    if (cloud % 20 == 0) cause_at("seldom", now + period / 2);
  }
  const double end = start + 100 * period;  // the last of the seldom ones came almost a second before
  EXPECT_EQ(cause_at("camera", end + 1.2), Cause::Seen) << "after two clouds that it missed";
}

}  // namespace
}  // namespace safety_control_cloud
