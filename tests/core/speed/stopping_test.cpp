// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/speed/stopping.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "../../../safety_control_cloud/core/settings.hpp"
#include "../sentences.hpp"

namespace safety_control_cloud {
namespace {

TEST(Stopping, OfATurtleBotByHand) {
  EXPECT_DOUBLE_EQ(reaction_time(0.5, {}), 0.05 + 0.5 + 0.5 + 0.6);
  EXPECT_DOUBLE_EQ(stopping_distance(0.2, 0.5, {}), 0.2 * 1.65 + 0.04 / 0.72);
  EXPECT_DOUBLE_EQ(slowing_distance(0.2, 0.1, 0.5, {}), 0.2 * 1.65 + 0.03 / 0.72);
  EXPECT_EQ(stopping_distance(0.0, 0.5, {}), 0.0);
}

/// From safe_speed: 0.2 x (0.05 + 2 x 0.5 + 0.6) + 0.2^2 / 0.72 + 0.265 = 0.651 m before the Warning zone ends ...
TEST(Stopping, WarningDistanceMustDoToStopFromSafeSpeed) {
  EXPECT_TRUE(doubts_about(Settings{}).empty());
  Settings settings;
  settings.limits = {0.65, 0.1};
  settings.speeds.warning = 0.0;
  settings.stopping.hull = 0.0;
  EXPECT_TRUE(doubts_about(settings).empty()) << doubts_about(settings)[0];
  settings.stopping.hull = 0.265;
  settings.speeds.warning = 0.0;
  ASSERT_TRUE(mentions(doubts_about(settings), "warning_distance 0.65 m is shorter than the 0.650556 m"));
  EXPECT_TRUE(mentions(doubts_about(settings), "from safe_speed 0.2 m/s"));
  EXPECT_TRUE(mentions(doubts_about(settings), "ISO 13855"));
}

/// ... and from warning_speed 0.1 x 1.65 + 0.1^2 / 0.72 + 0.265 = 0.444 m before the Danger zone begins.
TEST(Stopping, DangerDistanceMustDoToStopFromWarningSpeed) {
  Settings settings;
  settings.limits = {1.5, 0.444};
  EXPECT_TRUE(doubts_about(settings).empty()) << doubts_about(settings)[0];
  settings.limits.danger = 0.443;
  ASSERT_EQ(doubts_about(settings).size(), std::size_t{1});
  EXPECT_TRUE(mentions(doubts_about(settings), "danger_distance 0.443 m is shorter than the 0.443889 m"));
  EXPECT_TRUE(mentions(doubts_about(settings), "from warning_speed 0.1 m/s"));
}

/// 0.2 x 1.65 + (0.2^2 - 0.1^2) / 0.72 = 0.372 m.
TEST(Stopping, RobotMustHaveSlowedBeforeTheDangerZoneBegins) {
  Settings settings;
  settings.limits.danger = 0.63;
  ASSERT_EQ(doubts_about(settings).size(), std::size_t{1});
  EXPECT_TRUE(mentions(doubts_about(settings), "less than 0.371667 m before danger_distance"));
}

TEST(Stopping, LongerPatienceAndALongerHullNeedMoreRoom) {
  for (const auto& harm : std::vector<std::function<void(Settings&)>>{
           [](Settings& s) { s.source_timeout = 2.0; }, [](Settings& s) { s.stopping.hull = 0.4; },
           [](Settings& s) { s.stopping.base_timeout = 3.0; }, [](Settings& s) { s.stopping.sensor_period = 2.0; },
           [](Settings& s) { s.stopping.base_deceleration = 0.02; }, [](Settings& s) { s.speeds.safe = 0.5; }}) {
    Settings settings;
    harm(settings);
    EXPECT_FALSE(doubts_about(settings).empty());
  }
}

}  // namespace
}  // namespace safety_control_cloud
