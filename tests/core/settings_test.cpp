// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>

namespace safety_control_cloud {
namespace {

bool mentions(const std::vector<std::string>& sentences, const std::string& word) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& sentence) { return sentence.find(word) != std::string::npos; });
}

TEST(Settings, DefaultsAreFitToDriveWith) { EXPECT_TRUE(problems_in(Settings{}).empty()); }

TEST(Settings, NoNumberMayBeNanOrInfinite) {
  for (const double unfit : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
    std::size_t numbers = 0;
    const Settings defaults;
    for_each_parameter(defaults, [&](const std::string& name, const auto& value) {
      if constexpr (std::is_floating_point_v<std::decay_t<decltype(value)>>) {
        Settings settings;
        for_each_parameter(settings, [&](const std::string& candidate, auto& number) {
          if constexpr (std::is_floating_point_v<std::decay_t<decltype(number)>>) {
            if (candidate == name) number = static_cast<std::decay_t<decltype(number)>>(unfit);
          }
        });
        EXPECT_TRUE(mentions(problems_in(settings), name + " must be finite")) << name << " = " << unfit;
        ++numbers;
      }
    });
    EXPECT_GT(numbers, std::size_t{10});
  }
}

struct Unfit {
  const char* sentence;
  std::function<void(Settings&)> harm;
};

TEST(Settings, EveryContradictionIsNamed) {
  const std::vector<Unfit> table = {
      {"x_min must be less", [](Settings& s) { s.corridor.x_min = s.corridor.x_max; }},
      {"y_min must be less", [](Settings& s) { std::swap(s.corridor.y_min, s.corridor.y_max); }},
      {"range_min must not", [](Settings& s) { s.corridor.range_min = -0.1f; }},
      {"min_points must", [](Settings& s) { s.corridor.min_points = 0; }},
      {"danger_distance must be positive", [](Settings& s) { s.limits.danger = 0.0; }},
      {"danger_distance must be more", [](Settings& s) { s.corridor.range_min = 0.5f; }},
      {"warning_distance must be more", [](Settings& s) { std::swap(s.limits.danger, s.limits.warning); }},
      {"warning_speed must not", [](Settings& s) { s.speeds.warning = -0.1; }},
      {"safe_speed must not", [](Settings& s) { s.speeds.safe = 0.05; }},
      {"release_clouds must", [](Settings& s) { s.release.clouds = 0; }},
      {"release_time must", [](Settings& s) { s.release.time = -1.0; }},
      {"source_timeout must", [](Settings& s) { s.source_timeout = 0.0; }},
      {"min_valid_ratio must", [](Settings& s) { s.min_valid_ratio = 1.1; }},
      {"min_returns must", [](Settings& s) { s.min_returns = 0; }},
      {"left and right must", [](Settings& s) { s.frame_corridor.left = -s.frame_corridor.right; }},
      {"bottom must be less", [](Settings& s) { std::swap(s.frame_corridor.bottom, s.frame_corridor.top); }},
      {"stamp_tolerance must", [](Settings& s) { s.stamp_tolerance = -1.0; }},
      {"near_loss_distance must", [](Settings& s) { s.near_loss.distance = 2.8; }},
      {"near_loss_timeout must", [](Settings& s) { s.near_loss.timeout = -1.0; }},
      {"frozen_clouds must", [](Settings& s) { s.frozen_clouds = 1; }},
      {"sensor_period must", [](Settings& s) { s.stopping.sensor_period = -1.0; }},
      {"base_timeout must", [](Settings& s) { s.stopping.base_timeout = -1.0; }},
      {"base_deceleration must", [](Settings& s) { s.stopping.base_deceleration = 0.0; }},
      {"hull must", [](Settings& s) { s.stopping.hull = -0.1; }},
      {"with target_frame the corridor is",
       [](Settings& s) { s.target_frame = "base_footprint", s.corridor.x_max = 0.4f; }},
      {"need a target_frame", [](Settings& s) { s.frame_corridor.top = 0.6; }},
      {"publish_rate must", [](Settings& s) { s.publish_rate = 0.0; }},
  };
  for (const auto& [sentence, harm] : table) {
    Settings settings;
    harm(settings);
    EXPECT_TRUE(mentions(problems_in(settings), sentence)) << sentence;
  }
}

TEST(Settings, AllProblemsAreListedAtOnce) {
  Settings settings;
  settings.corridor.x_min = 1.0f;
  settings.speeds.warning = -1.0;
  settings.publish_rate = -1.0;
  EXPECT_EQ(problems_in(settings).size(), std::size_t{3});
}

TEST(Settings, CorridorInTheTargetFrameIsGivenByDistancesAndHeights) {
  Settings settings;
  settings.target_frame = "base_footprint";
  settings.frame_corridor = {0.4, 0.3, 0.1, 0.6};
  const Corridor corridor = corridor_of(settings);
  EXPECT_EQ(corridor.x_min, -0.4f) << "left";
  EXPECT_EQ(corridor.x_max, 0.3f) << "right";
  EXPECT_EQ(corridor.y_min, -0.6f) << "top: y points down";
  EXPECT_EQ(corridor.y_max, -0.1f) << "bottom";
}

/// As dynamic_reconfigure may send them: no bound, and the largest there is.
TEST(Settings, EveryNumberHasABoundThatItsRefusalNames) {
  std::size_t numbers = 0;
  const Settings defaults;
  for_each_parameter(defaults, [&](const std::string& name, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_arithmetic_v<Value>) {
      Settings settings;
      for_each_parameter(settings, [&](const std::string& candidate, auto& number) {
        if constexpr (std::is_same_v<std::decay_t<decltype(number)>, Value>) {
          if (candidate == name) number = static_cast<Value>(std::numeric_limits<std::int32_t>::max());
        }
      });
      const auto problems = problems_in(settings);
      EXPECT_TRUE(mentions(problems, name + " must be at most ") || mentions(problems, name + " must lie between "))
          << name;
      ++numbers;
    }
  });
  EXPECT_GT(numbers, std::size_t{20});
}

TEST(Settings, WhatDisablesACheckIsRefusedWithItsBound) {
  Settings patient, blind, fast;
  patient.source_timeout = 3600.0;
  blind.corridor.min_points = 2147483647;
  fast.speeds.safe = 5.0;
  EXPECT_TRUE(mentions(problems_in(patient), "source_timeout must be at most 10"));
  EXPECT_TRUE(mentions(problems_in(blind), "min_points must be at most 1000"));
  EXPECT_TRUE(mentions(problems_in(fast), "safe_speed must be at most 1.5"));
  Settings aside;
  aside.corridor.x_min = -1e6f;
  EXPECT_TRUE(mentions(problems_in(aside), "x_min must be at least -10"));
}

/// From safe_speed: 0.2 x (0.05 + 2 x 0.5 + 0.6) + 0.2^2 / 0.72 + 0.265 = 0.651 m before the Warning zone ends ...
TEST(Settings, WarningDistanceMustDoToStopFromSafeSpeed) {
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
TEST(Settings, DangerDistanceMustDoToStopFromWarningSpeed) {
  Settings settings;
  settings.limits = {1.5, 0.444};
  EXPECT_TRUE(doubts_about(settings).empty()) << doubts_about(settings)[0];
  settings.limits.danger = 0.443;
  ASSERT_EQ(doubts_about(settings).size(), std::size_t{1});
  EXPECT_TRUE(mentions(doubts_about(settings), "danger_distance 0.443 m is shorter than the 0.443889 m"));
  EXPECT_TRUE(mentions(doubts_about(settings), "from warning_speed 0.1 m/s"));
}

/// 0.2 x 1.65 + (0.2^2 - 0.1^2) / 0.72 = 0.372 m.
TEST(Settings, RobotMustHaveSlowedBeforeTheDangerZoneBegins) {
  Settings settings;
  settings.limits.danger = 0.63;
  ASSERT_EQ(doubts_about(settings).size(), std::size_t{1});
  EXPECT_TRUE(mentions(doubts_about(settings), "less than 0.371667 m before danger_distance"));
}

TEST(Settings, LongerPatienceAndALongerHullNeedMoreRoom) {
  for (const auto& harm : std::vector<std::function<void(Settings&)>>{
           [](Settings& s) { s.source_timeout = 2.0; }, [](Settings& s) { s.stopping.hull = 0.4; },
           [](Settings& s) { s.stopping.base_timeout = 3.0; }, [](Settings& s) { s.stopping.sensor_period = 2.0; },
           [](Settings& s) { s.stopping.base_deceleration = 0.02; }, [](Settings& s) { s.speeds.safe = 0.5; }}) {
    Settings settings;
    harm(settings);
    EXPECT_FALSE(doubts_about(settings).empty());
  }
}

TEST(Settings, MethodsAreFoundByTheirNames) {
  EXPECT_EQ(method_named("one_pass"), Method::OnePass);
  EXPECT_EQ(method_named("pcl"), Method::Pcl);
  EXPECT_FALSE(method_named("PCL"));
}

}  // namespace
}  // namespace safety_control_cloud
