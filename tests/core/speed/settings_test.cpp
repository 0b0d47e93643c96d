// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/speed/settings.hpp"

#include <gtest/gtest.h>

#include "../sentences.hpp"

namespace safety_control_cloud {
namespace {

TEST(SpeedSettings, DefaultsAreFit) { EXPECT_TRUE(problems_of_defaults<SpeedSettings>().empty()); }

TEST(SpeedSettings, EveryContradictionIsNamed) {
  EXPECT_EQ(
      untold<SpeedSettings>({
          {"danger_distance must be positive", [](SpeedSettings& s) { s.limits.danger = 0.0; }},
          {"warning_distance must be more", [](SpeedSettings& s) { std::swap(s.limits.danger, s.limits.warning); }},
          {"warning_speed must not", [](SpeedSettings& s) { s.speeds.warning = -0.1; }},
          {"safe_speed must not", [](SpeedSettings& s) { s.speeds.safe = 0.05; }},
          {"release_clouds must", [](SpeedSettings& s) { s.release.clouds = 0; }},
          {"release_time must", [](SpeedSettings& s) { s.release.time = -1.0; }},
          {"sensor_period must", [](SpeedSettings& s) { s.stopping.sensor_period = -1.0; }},
          {"base_timeout must", [](SpeedSettings& s) { s.stopping.base_timeout = -1.0; }},
          {"base_deceleration must", [](SpeedSettings& s) { s.stopping.base_deceleration = 0.0; }},
          {"hull must", [](SpeedSettings& s) { s.stopping.hull = -0.1; }},
      }),
      std::vector<std::string>{});
}

}  // namespace
}  // namespace safety_control_cloud
