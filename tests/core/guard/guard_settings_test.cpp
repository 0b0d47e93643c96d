// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "../../../safety_control_cloud/core/settings.hpp"

namespace safety_control_cloud {
namespace {

TEST(Lists, AreReadAsPeopleWriteThem) {
  using Numbers = std::vector<std::vector<double>>;
  EXPECT_EQ(lists_in({""}, 2), Numbers{});
  EXPECT_EQ(lists_in({" [] "}, 2), Numbers{});
  EXPECT_EQ(lists_in({"[[0.2,-1], [ 3e-1 , 4 ]]"}, 2), (Numbers{{0.2, -1.0}, {0.3, 4.0}}));
}

TEST(Lists, OfAnotherKindAreNone) {
  for (const char* text : {"[", "[[1]]", "[[1,2,3]]", "[[1,2],]", "[[1,2]] x", "[[1,a]]", "[1,2]", "[[,]]", "[[1,2]",
                           "x", "[] x", "[[nan,1]]"})
    EXPECT_FALSE(lists_in({text}, 2)) << text;
}

bool mentions(const Settings& settings, const std::string& words) {
  const auto problems = problems_in(settings);
  return std::any_of(problems.begin(), problems.end(),
                     [&](const std::string& problem) { return problem.find(words) != std::string::npos; });
}

TEST(GuardSettings, TheGuardIsFitAsItIsMade) {
  Settings settings;
  settings.mode = Mode::Guard;
  EXPECT_TRUE(problems_in(settings).empty());
  EXPECT_TRUE(doubts_about(settings).empty());
}

TEST(GuardSettings, LooksAndCommandsThatComeTooSeldomAreNamed) {
  Settings settings;
  settings.mode = Mode::Guard;
  settings.source_timeout = 0.2, settings.stopping.sensor_period = 0.25;
  settings.publish_rate = 2.0, settings.stopping.base_timeout = 0.2;
  ASSERT_EQ(doubts_about(settings).size(), 2u);
  EXPECT_EQ(doubts_about(settings)[0],
            "source_timeout 0.200 s is less than sensor_period 0.250 s: it counts as silent between one look and the "
            "next");
  EXPECT_EQ(
      doubts_about(settings)[1],
      "at this sensor_period and publish_rate 2 commands may be 0.250 s apart, and after base_timeout 0.200 s the "
      "base stops");
  settings.sensors = {{"fast", InputKind::Cloud, "fast", true, {{"sensor_period", 0.1}}},
                      {"slow", InputKind::Scan, "slow", true, {{"source_timeout", 0.1}}}};
  ASSERT_EQ(doubts_about(settings).size(), 1u) << "the fast one's looks are answered too";
  EXPECT_EQ(doubts_about(settings)[0].rfind("sensors, slow: source_timeout", 0), 0u);
}

TEST(GuardSettings, OfNoMarginNothingIsSaidThatNobodySet) {
  Settings settings;
  settings.mode = Mode::Guard;
  settings.margin = -1.0;
  EXPECT_TRUE(mentions(settings, "margin"));
  EXPECT_FALSE(mentions(settings, "left and right"));
}

TEST(GuardSettings, EveryContradictionIsNamed) {
  const std::vector<std::pair<const char*, std::function<void(Settings&)>>> table = {
      {"footprint must be a list", [](Settings& s) { s.footprint.text = "[[1, 2, 3]]"; }},
      {"at least 3 corners", [](Settings& s) { s.footprint.text = "[[0, 1], [1, 0]]"; }},
      {"farther than 3 m", [](Settings& s) { s.footprint.text = "[[0, 1], [4, 0], [0, -1]]"; }},
      {"footprint: ", [](Settings& s) { s.radius = 0.0; }},
      {"self_boxes must be", [](Settings& s) { s.self_boxes.text = "[[1, 2]]"; }},
      {"min less than max", [](Settings& s) { s.self_boxes.text = "[[1, 0, 0, 1, 0, 1]]"; }},
      {"base_frame must not be empty", [](Settings& s) { s.base_frame = ""; }},
      {"base_frame must not begin", [](Settings& s) { s.base_frame = "/base"; }},
      {"odom_frame must not begin", [](Settings& s) { s.odom_frame = "/odom"; }},
      {"command_max_age must", [](Settings& s) { s.command_max_age = 0.0; }},
      {"command_timeout must", [](Settings& s) { s.command_timeout = 0.0; }},
      {"max_speed must", [](Settings& s) { s.max_speed = 0.0; }},
      {"max_turn must", [](Settings& s) { s.max_turn = 0.0; }},
      {"min_speed must", [](Settings& s) { s.min_speed = -0.1; }},
      {"escape_speed must", [](Settings& s) { s.escape_speed = -0.1; }},
      {"unseen_speed must", [](Settings& s) { s.unseen_speed = -0.1; }},
      {"min_speed must not be above", [](Settings& s) { s.min_speed = s.max_speed + 0.1; }},
      {"escape_speed must be 0 or", [](Settings& s) { s.min_speed = 0.11, s.unseen_speed = 0.2; }},
      {"unseen_speed must be 0 or", [](Settings& s) { s.min_speed = 0.11, s.escape_speed = 0.2; }},
      {"override_speed must be at least", [](Settings& s) { s.min_speed = 0.05, s.override_speed = 0.04; }},
      {"override_max must", [](Settings& s) { s.override_max = -1.0; }},
      {"override_max must be at most", [](Settings& s) { s.override_max = 61.0; }},
      {"override_speed must", [](Settings& s) { s.override_speed = 0.0; }},
      {"latency must", [](Settings& s) { s.latency = -0.1; }},
      {"base_reaction must", [](Settings& s) { s.base_reaction = -0.1; }},
      {"angular_deceleration must", [](Settings& s) { s.angular_deceleration = 0.0; }},
      {"obstacle_speed must", [](Settings& s) { s.obstacle_speed = -0.1; }},
      {"noise must", [](Settings& s) { s.noise = -0.1; }},
      {"not target_frame", [](Settings& s) { s.target_frame = "base_footprint"; }},
      {"what left and right", [](Settings& s) { s.frame_corridor.left = 0.4; }},
  };
  for (const auto& [sentence, harm] : table) {
    Settings settings;
    settings.mode = Mode::Guard;
    harm(settings);
    EXPECT_TRUE(mentions(settings, sentence)) << sentence;
  }
}

/// And nothing that he has not set who set one of these.
TEST(GuardSettings, WhatIsOfModeDriveOrMissingIsNamedOnce) {
  const std::vector<std::pair<const char*, std::function<void(Settings&)>>> table = {
      {"base_frame must not be empty", [](Settings& s) { s.base_frame = ""; }},
      {"what left and right", [](Settings& s) { s.frame_corridor.left = 0.4; }},
      {"what x_min, x_max, y_min and y_max", [](Settings& s) { s.corridor.x_min = -0.4f; }},
      {"what x_min, x_max, y_min and y_max", [](Settings& s) { s.corridor.y_max = -0.4f; }},
  };
  for (const auto& [sentence, harm] : table) {
    Settings settings;
    settings.mode = Mode::Guard;
    harm(settings);
    EXPECT_TRUE(mentions(settings, sentence)) << sentence;
    EXPECT_EQ(problems_in(settings).size(), std::size_t{1}) << sentence;
  }
}

TEST(GuardSettings, ItsSensorLooksDownACorridorAsWideAsTheRobot) {
  Settings settings;
  settings.mode = Mode::Guard;
  settings.footprint.text = "[[0.5, 0.2], [-0.1, 0.2], [-0.1, -0.3], [0.5, -0.3]]";
  const Settings sensor = sensor_settings(settings);
  EXPECT_EQ(sensor.target_frame, "base_footprint");
  EXPECT_DOUBLE_EQ(sensor.frame_corridor.left, 0.25);
  EXPECT_DOUBLE_EQ(sensor.frame_corridor.right, 0.35);
  EXPECT_DOUBLE_EQ(sensor.limits.danger, 1.0);
}

}  // namespace
}  // namespace safety_control_cloud
