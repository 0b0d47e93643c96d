// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/doubt/stamps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace safety_control_cloud {
namespace {

/// Clouds at 20 Hz, each with an age.
class Stamped {
 public:
  Cause cause_at(double age) {
    now_ += 0.05;
    const auto doubt = watch.note(age, now_, settings);
    reason = doubt ? doubt->reason : "";
    return doubt ? doubt->cause : Cause::Seen;
  }

  /// What is said of the last of so many [s] of clouds, whose age grows by `growth` [s/s].
  Cause after(double seconds, double age, double growth = 0.0) {
    Cause cause = Cause::Seen;
    for (double passed = 0.0; passed < seconds; passed += 0.05) cause = cause_at(age + growth * passed);
    return cause;
  }

  void pass(double seconds) { now_ += seconds; }

  StampWatch watch;
  DoubtSettings settings;
  std::string reason;

 private:
  double now_ = 1000.0;
};

TEST(Stamps, CloudThatComesLaterThanOthersByMoreThanTheTimeoutIsNoReasonToDrive) {
  for (const double offset : {-0.7, 0.0, 0.05, 0.3}) {
    Stamped camera;
    EXPECT_EQ(camera.after(1.0, offset), Cause::Seen) << offset;
    EXPECT_EQ(camera.cause_at(offset + 0.49), Cause::Seen) << offset;
    EXPECT_EQ(camera.cause_at(offset + 0.52), Cause::Stale) << offset;
    EXPECT_NE(camera.reason.find("later than others"), std::string::npos) << camera.reason;
    EXPECT_EQ(camera.cause_at(offset), Cause::Seen) << offset;
  }
}

TEST(Stamps, OneWrongStampIsNoReasonToStandForEver) {
  for (const double ahead : {0.55, 0.8, 0.95}) {
    Stamped camera;
    camera.after(2.0, 0.03);
    EXPECT_EQ(camera.cause_at(-ahead), Cause::Future) << ahead;
    EXPECT_EQ(camera.cause_at(0.03), Cause::Seen) << ahead;
    Stamped at_first;
    at_first.cause_at(-ahead);
    EXPECT_EQ(at_first.after(0.2, 0.03), Cause::Seen) << ahead;
  }
}

TEST(Stamps, CameraWhoseClockIsSetForwardIsBelievedAfterASecond) {
  Stamped camera;
  camera.after(2.0, 0.03);
  EXPECT_EQ(camera.after(0.9, -0.7), Cause::Future);
  EXPECT_EQ(camera.after(0.3, -0.7), Cause::Seen);
  EXPECT_EQ(camera.cause_at(0.03), Cause::Stale);
}

TEST(Stamps, TimeoutSaysHowOldACloudMayBe) {
  Stamped camera;
  camera.settings.source_timeout = 0.2;
  camera.after(1.0, 0.0);
  EXPECT_EQ(camera.cause_at(0.25), Cause::Stale);
}

TEST(Stamps, AgeThatGrowsAsAQueueDoesIsNoticedWithinTheTimeout) {
  for (const double growth : {0.01, 0.1, 0.5}) {
    Stamped camera;
    camera.after(5.0, 0.05);
    EXPECT_EQ(camera.after(0.45 / growth, 0.05, growth), Cause::Seen) << growth;
    EXPECT_EQ(camera.after(0.2 / growth, 0.05 + 0.45, growth), Cause::Stale) << growth;
  }
}

TEST(Stamps, QueueThatStaysLongIsNeverTakenForAnOffset) {
  Stamped camera;
  camera.after(5.0, 0.05);
  EXPECT_EQ(camera.after(3600.0, 0.7), Cause::Stale);
  camera.watch.forget();
  EXPECT_EQ(camera.cause_at(0.7), Cause::Seen) << "somebody has looked";
}

TEST(Stamps, ClockThatDriftsAwayOverHoursIsFollowed) {
  for (const double drift : {1e-4, -1e-4, 5e-4, -5e-4}) {
    Stamped camera;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> latency(0.03, 0.2);
    int doubted = 0;
    double age = 0.0;
    for (double passed = 0.0; passed < 8 * 3600.0; passed += 0.05) {
      age = drift * passed;
      doubted += camera.cause_at(age + latency(random)) != Cause::Seen;
    }
    EXPECT_EQ(doubted, 0) << drift;
    EXPECT_EQ(camera.cause_at(age + 0.8), Cause::Stale) << "one of its clouds that is late";
  }
}

TEST(Stamps, ClockThatHasDriftedByAMinuteHasToBeSet) {
  Stamped camera;
  EXPECT_EQ(camera.after(70000.0, 0.0, 9e-4), Cause::Stale);
}

TEST(Stamps, OffsetFromTheStartBeyondTheToleranceIsNotExplained) {
  Stamped late, early;
  EXPECT_EQ(late.after(3600.0, 5.0), Cause::Stale);
  EXPECT_NE(late.reason.find("5.000 s old, a steady offset"), std::string::npos) << late.reason;
  EXPECT_EQ(early.after(3600.0, -60.0), Cause::Future);
  EXPECT_NE(early.reason.find("60.000 s ahead, a steady offset"), std::string::npos) << early.reason;
}

TEST(Stamps, AgeThatGrowsBeyondTheToleranceIsSaidToGrow) {
  Stamped camera;
  EXPECT_EQ(camera.after(5.0, 2.0, 0.1), Cause::Stale);
  EXPECT_NE(camera.reason.find("ever older"), std::string::npos) << camera.reason;
}

TEST(Stamps, JumpIsNotFollowedAndItsEndIsSeenAtOnce) {
  Stamped camera;
  camera.after(5.0, 0.05);
  EXPECT_EQ(camera.after(10.0, 5.05), Cause::Stale);
  EXPECT_EQ(camera.cause_at(0.05), Cause::Seen);
  EXPECT_EQ(camera.after(10.0, -5.0), Cause::Future);
  EXPECT_EQ(camera.cause_at(0.05), Cause::Seen);
}

TEST(Stamps, CloudFromBeforeAPauseIsStale) {
  Stamped camera;
  camera.after(5.0, 0.05);
  camera.pass(2.0);
  EXPECT_EQ(camera.cause_at(0.9), Cause::Stale) << "it was still in the socket";
}

TEST(Stamps, NanIsNoAge) {
  Stamped camera;
  EXPECT_EQ(camera.cause_at(std::numeric_limits<double>::quiet_NaN()), Cause::Stale);
  EXPECT_EQ(camera.cause_at(0.05), Cause::Seen);
}

TEST(Stamps, NothingOfThisHoldsWhereTheToleranceIsOff) {
  Stamped camera;
  camera.settings.stamp_tolerance = 0.0;
  EXPECT_EQ(camera.after(60.0, 1e9, 1.0), Cause::Seen);
}

}  // namespace
}  // namespace safety_control_cloud
