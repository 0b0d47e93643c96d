// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/sensor.hpp"

#include <gtest/gtest.h>

#include "scene.hpp"

namespace safety_control_cloud {
namespace {

const std::vector<Xyz> free_way = {{0, 0, 3}};

/// Seen, or what is doubted.
Cause said_by(const Sensor& sensor) {
  const auto* doubt = std::get_if<Doubt>(&sensor.answer());
  return doubt ? doubt->cause : Cause::Seen;
}

Cause said_of(const Reading& reading, Sensor& sensor, const Origin& origin, const Instant& now) {
  sensor.see(reading, origin, now);
  return said_by(sensor);
}

Cause said_at(double now, Sensor& sensor, const std::vector<Xyz>& points = free_way) {
  return said_of(view_of(points), sensor, Origin{now}, {now, now});
}

Cause said_in_silence(Sensor& sensor, const Instant& now) {
  sensor.wait(now);
  return said_by(sensor);
}

TEST(Sensor, CloudFromThePastOrTheFutureIsNotBelieved) {
  Sensor sensor{Settings{}};
  EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{8.9}, {10, 10}), Cause::Stale);
  EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{11.1}, {10, 10}), Cause::Future);
  EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{0.0}, {10, 10}), Cause::Stale);
  EXPECT_NE(said_of(view_of(free_way), sensor, Origin{nan}, {10, 10}), Cause::Seen);
  EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{9.1}, {10, 10}), Cause::Seen);
}

TEST(Sensor, StampsDoNotMatterWhereTheToleranceIsOff) {
  Settings settings;
  settings.stamp_tolerance = 0.0;
  Sensor sensor{settings};
  EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{-1e9}, {10, 10}), Cause::Seen);
}

TEST(Sensor, AfterAJumpOfTheClockItTakesAFreshCloud) {
  Sensor sensor{Settings{}};
  sensor.see(view_of(free_way), Origin{100}, {10, 100});
  EXPECT_EQ(said_in_silence(sensor, {10.1, 5.0}), Cause::ClockJump);
  EXPECT_EQ(said_in_silence(sensor, {10.2, 5.1}), Cause::ClockJump);
  EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{100.1}, {10.2, 5.1}), Cause::Future);
  EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{5.2}, {10.3, 5.2}), Cause::Seen);
  EXPECT_EQ(said_in_silence(sensor, {10.4, 5.15}), Cause::Seen) << "a clock set right by 50 ms is no jump";
}

TEST(Sensor, WithoutATransformNothingIsLookedAt) {
  Sensor sensor{Settings{}};
  const Origin nowhere{1.0, NoTransform{"no base_link"}};
  EXPECT_EQ(said_of(view_of(free_way), sensor, nowhere, {1, 1}), Cause::NoTransform);
  EXPECT_EQ(std::get<Doubt>(sensor.answer()).reason, "no base_link");
  EXPECT_EQ(sensor.counted().total, std::size_t{0});
}

TEST(Sensor, FrozenCameraIsNotBelievedUntilItsContentChanges) {
  Settings settings;
  settings.frozen_clouds = 3;
  Sensor sensor{settings};
  EXPECT_EQ(said_at(1.0, sensor), Cause::Seen);
  EXPECT_EQ(said_at(1.1, sensor), Cause::Seen);
  EXPECT_EQ(said_at(1.2, sensor), Cause::Frozen);
  EXPECT_EQ(said_at(1.3, sensor), Cause::Frozen);
  EXPECT_EQ(said_at(1.4, sensor, {{0, 0, 3.001f}}), Cause::Seen);
}

TEST(Sensor, SameCloudSentAgainIsNoFrozenCamera) {
  Settings settings;
  settings.frozen_clouds = 2;
  Sensor sensor{settings};
  sensor.see(view_of(free_way), Origin{1.0}, {1, 1});
  EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{1.0}, {1.1, 1.1}), Cause::Seen) << "its stamp will give it away";
}

/// It takes two clouds that show the floor before a kerb again, for that to have gone.
TEST(Sensor, WhatIsSeenInARepeatedCloudIsSeenOnce) {
  Settings settings;
  settings.frozen_clouds = 100;
  Sensor sensor{settings};
  auto is_lost = [&, now = 1.0](const Scene& scene, double after = 0.05) mutable {
    now += after;
    sensor.see(scene.view(), Origin{now}, {now, now});
    return std::get<Seen>(sensor.answer()).loss.has_value();
  };
  for (const float z : {0.74f, 0.72f, 0.70f, 0.66f, 0.63f})
    EXPECT_TRUE(is_lost(Scene({{z, -0.2f, 0.2f, floor_y - 0.05f, floor_y}}))) << z;
  const Scene free;
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(is_lost(free, 0.01)) << i;  // in a longer while it might roll on
  EXPECT_FALSE(is_lost(Scene({{4.0f, -0.2f, 0.2f, -0.3f, floor_y}})));
}

TEST(Sensor, WhileRosTimeIsZeroNoStampIsBelieved) {
  Sensor sensor{Settings{}};
  EXPECT_EQ(said_in_silence(sensor, {1.0, 0.0}), Cause::NoTime);
  for (const double stamp : {0.0, 0.3, 1e9}) {
    EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{stamp}, {2.0, 0.0}), Cause::NoTime) << stamp;
    EXPECT_NE(std::get<Doubt>(sensor.answer()).reason.find("/clock"), std::string::npos);
  }
  EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{0.1}, {3.0, 0.1}), Cause::Seen) << "the clock has started";
}

TEST(Sensor, CloudOfBeforeAPauseIsStale) {
  Sensor sensor{Settings{}};
  for (double now = 10.0; now < 11.0; now += 0.05) sensor.see(view_of(free_way), Origin{now - 0.02}, {now, now});
  EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{12.2}, {13.0, 13.0}), Cause::Stale);
  EXPECT_EQ(said_of(view_of(free_way), sensor, Origin{13.03}, {13.05, 13.05}), Cause::Seen);
}

TEST(Sensor, CloudOfValidPointsThatShrinksIsBlindUntilSomebodyHasLooked) {
  Sensor sensor{Settings{}};
  EXPECT_EQ(said_at(1.0, sensor, std::vector<Xyz>(3000, Xyz{0, 0, 3})), Cause::Seen);
  EXPECT_EQ(said_at(1.05, sensor), Cause::Blind);
  sensor.forget_losses();
  EXPECT_EQ(said_at(1.1, sensor), Cause::Seen);
}

TEST(Sensor, SilenceIsAnAnswerOnlyAfterItsTime) {
  Sensor sensor{Settings{}};
  EXPECT_EQ(said_in_silence(sensor, {99.0, 99.0}), Cause::NoCloud) << "there was none yet";
  said_at(100.0, sensor);
  EXPECT_EQ(sensor.counted().total, std::size_t{1});
  EXPECT_EQ(said_in_silence(sensor, {100.5, 100.5}), Cause::Seen);
  EXPECT_EQ(said_in_silence(sensor, {100.51, 100.51}), Cause::Silent);
  EXPECT_EQ(sensor.counted().total, std::size_t{0});
}

TEST(Sensor, WhatAnotherProcessLostIsSaidToBeOfBeforeThisStart) {
  Sensor first{Settings{}};
  const Scene board{{{0.45f, -0.2f, 0.2f, -0.2f, 0.2f}, {3.0f, -9, 9, -9, 9}}};
  const Scene passed{{{0.39f, -0.2f, 0.2f, -0.2f, 0.2f}, {3.0f, -9, 9, -9, 9}}};
  first.see(board.view(), Origin{1.0}, {1.0, 1.0});
  first.see(passed.view(), Origin{1.05}, {1.05, 1.05});
  ASSERT_TRUE(std::get<Seen>(first.answer()).loss);
  Sensor second{Settings{}};
  ASSERT_TRUE(second.recall(first.remembered()));
  EXPECT_FALSE(second.recall("nonsense"));
  ASSERT_TRUE(second.recall(first.remembered()));
  second.see(passed.view(), Origin{2.0}, {2.0, 2.0});
  const auto loss = std::get<Seen>(second.answer()).loss;
  ASSERT_TRUE(loss);
  EXPECT_NE(loss->reason.find("as before this start"), std::string::npos) << loss->reason;
}

}  // namespace
}  // namespace safety_control_cloud
