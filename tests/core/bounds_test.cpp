// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/bounds.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <type_traits>

#include "../../safety_control_cloud/core/settings.hpp"
#include "sentences.hpp"

namespace safety_control_cloud {
namespace {

/// As dynamic_reconfigure may send them: no bound, and the largest there is.
TEST(Bounds, EveryNumberHasABoundThatItsRefusalNames) {
  std::size_t numbers = 0;
  const Settings defaults;
  for_each_parameter(defaults, [&](const std::string& name, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
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

TEST(Bounds, WhatDisablesACheckIsRefusedWithItsBound) {
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

TEST(Bounds, ANumberOnItsBoundIsFit) {
  Problems problems;
  check_bound("hull", 10.0, problems);
  check_bound("x_min", -10.0, problems);
  check_bound("of no such name", 1e9, problems);
  EXPECT_EQ(problems.sentences, std::vector<std::string>{});
  check_bound("hull", 10.001, problems);
  check_bound("x_min", -10.001, problems);
  EXPECT_EQ(problems.sentences, (std::vector<std::string>{"hull must be at most 10", "x_min must be at least -10"}));
}

}  // namespace
}  // namespace safety_control_cloud
