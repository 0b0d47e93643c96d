// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/time/wake.hpp"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>

namespace safety_control_cloud {
namespace {

/// Somebody who is called back, and sees to his queue.
struct Sleeper {
  ros::CallbackQueue queue;
  int calls = 0;
  ros::SteadyTime asked = ros::SteadyTime::now(), called;
  Wake wake{queue, [this] {
              ++calls;
              called = ros::SteadyTime::now();
            }};

  /// The clock is read first: whoever is kept waiting then is called later, not too soon.
  void ask_for(double seconds) {
    asked = ros::SteadyTime::now();
    wake.in(seconds);
  }

  /// Since it was asked for.
  double seconds_until_called(double patience) {
    const ros::SteadyTime begun = ros::SteadyTime::now();
    const int before = calls;
    while (calls == before && (ros::SteadyTime::now() - begun).toSec() < patience)
      queue.callAvailable(ros::WallDuration(0.01));
    return calls == before ? -1.0 : (called - asked).toSec();
  }
};

void sleep(double seconds) { ros::WallDuration(seconds).sleep(); }

TEST(Wake, CallsOnceWhenItIsDueAndNotBefore) {
  Sleeper sleeper;
  sleeper.ask_for(0.1);
  EXPECT_GE(sleeper.seconds_until_called(10.0), 0.099);
  EXPECT_EQ(sleeper.seconds_until_called(0.2), -1.0);
}

TEST(Wake, WhoSaysNoMomentIsNotCalled) {
  Sleeper sleeper;
  EXPECT_EQ(sleeper.seconds_until_called(0.1), -1.0);
}

TEST(Wake, AMomentIsPutOffAgainAndAgain) {
  Sleeper sleeper;
  for (int i = 0; i < 20; ++i) {
    sleeper.ask_for(10.0);
    sleep(0.001);
  }
  sleeper.ask_for(0.15);
  sleeper.ask_for(0.2);
  EXPECT_GE(sleeper.seconds_until_called(10.0), 0.199);
}

TEST(Wake, ASoonerMomentCounts) {
  Sleeper sleeper;
  sleeper.ask_for(1000.0);
  sleep(0.05);
  sleeper.ask_for(0.05);
  EXPECT_GE(sleeper.seconds_until_called(10.0), 0.049);
}

TEST(Wake, WhatIsPastIsDueAtOnce) {
  Sleeper sleeper;
  sleeper.ask_for(-1.0);
  EXPECT_GE(sleeper.seconds_until_called(10.0), 0.0);
}

/// The queue was busy while it became due.
TEST(Wake, WhatIsPutOffInTheQueueIsNotCalled) {
  Sleeper sleeper;
  sleeper.ask_for(0.01);
  sleep(0.1);
  sleeper.ask_for(0.2);
  EXPECT_GE(sleeper.seconds_until_called(10.0), 0.19);
  EXPECT_EQ(sleeper.calls, 1);
}

TEST(Wake, WhoLeavesIsNotCalledAnyMore) {
  ros::CallbackQueue queue;
  int calls = 0;
  {
    Wake wake(queue, [&] { ++calls; });
    wake.in(0.01);
    sleep(0.1);
  }
  queue.callAvailable(ros::WallDuration(0.05));
  EXPECT_EQ(calls, 0);
}

}  // namespace
}  // namespace safety_control_cloud
