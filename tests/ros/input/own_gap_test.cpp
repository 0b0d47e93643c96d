// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/input/own_gap.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

Settings half_a_second() {
  Settings settings;
  settings.source_timeout = 0.5;
  settings.publish_rate = 10.0;
  return settings;
}

const Settings limit = half_a_second();

TEST(OwnGap, WhoNeverStoodStillDoubtsNothing) {
  OwnGap gap;
  for (double now = 10.0; now < 20.0; now += 0.4) {
    gap.beat({now, 1000.0 + now}, limit);
    EXPECT_FALSE(gap.doubt_about(0.0, {now, 1000.0 + now}, limit));
  }
}

TEST(OwnGap, ACloudFromBeforeTheNodeWentOnIsDoubtedForAShortTime) {
  OwnGap gap;
  gap.beat({10.0, 1010.0}, limit);
  gap.beat({12.0, 1012.0}, limit);
  EXPECT_EQ(gap.doubt_about(1011.9, {12.0, 1012.0}, limit)->reason,
            "the cloud is from before this node went on, which had stood still for 2.000 s");
  EXPECT_TRUE(gap.doubt_about(1010.0, {12.4, 1012.4}, limit));
  EXPECT_FALSE(gap.doubt_about(1012.1, {12.1, 1012.1}, limit)) << "taken since";
  EXPECT_FALSE(gap.doubt_about(1012.3, {12.6, 1012.6}, limit)) << "by a clock that runs late";
}

/// However patient it is with its camera.
TEST(OwnGap, WhatWasAskedOfWhoStoodStillForLongerThanACommandHoldsMayHaveWaited) {
  Settings patient = limit;
  patient.mode = Mode::Guard;
  patient.source_timeout = 10.0;
  patient.command_timeout = 0.5;
  for (const double stood : {0.4, 0.6, 4.0}) {
    OwnGap gap;
    gap.beat({10.0, 1010.0}, patient);
    const auto ended = gap.beat({10.0 + stood, 1010.0 + stood}, patient);
    EXPECT_EQ(ended.has_value(), stood > 0.5);
    EXPECT_NEAR(ended.value_or(stood), stood, 1e-9);
    EXPECT_EQ(gap.has_gone_on_within(0.5, {10.1 + stood, 1010.1 + stood}), stood > 0.5) << stood;
    EXPECT_FALSE(gap.doubt_about(1010.0, {10.1 + stood, 1010.1 + stood}, patient)) << stood;
  }
}

TEST(OwnGap, KnowsForHowLongTheNodeHasGoneOn) {
  OwnGap gap;
  gap.beat({10.0, 1010.0}, limit);
  EXPECT_FALSE(gap.has_gone_on_within(0.2, {10.0, 1010.0})) << "a start is no going on";
  gap.beat({12.0, 1012.0}, limit);
  EXPECT_TRUE(gap.has_gone_on_within(0.2, {12.1, 1012.1}));
  EXPECT_FALSE(gap.has_gone_on_within(0.2, {12.3, 1012.3}));
}

}  // namespace
}  // namespace safety_control_cloud
