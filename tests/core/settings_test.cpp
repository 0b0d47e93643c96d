// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/settings.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <type_traits>

#include "sentences.hpp"

namespace safety_control_cloud {
namespace {

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

/// Those between rooms; the rooms' own tests have the rest.
TEST(Settings, EveryContradictionIsNamed) {
  const std::vector<Unfit> table = {
      {"danger_distance must be more", [](Settings& s) { s.corridor.range_min = 0.5f; }},
      {"near_loss_distance must", [](Settings& s) { s.near_loss.distance = 2.8; }},
      {"near_loss_timeout must", [](Settings& s) { s.near_loss.timeout = -1.0; }},
      {"publish_rate must", [](Settings& s) { s.publish_rate = 0.0; }},
  };
  for (const auto& [sentence, harm] : table) {
    Settings settings;
    harm(settings);
    EXPECT_TRUE(mentions(problems_in(settings), sentence)) << sentence;
  }
}

TEST(Settings, ProblemsOfAllRoomsAreListedAtOnce) {
  Settings settings;
  settings.corridor.x_min = 1.0f;
  settings.min_returns = 0;
  settings.near_loss.timeout = -1.0;
  settings.speeds.warning = -1.0;
  settings.publish_rate = -1.0;
  EXPECT_EQ(problems_in(settings).size(), std::size_t{5});
}

}  // namespace
}  // namespace safety_control_cloud
