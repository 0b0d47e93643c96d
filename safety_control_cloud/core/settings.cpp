// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

#include <cmath>
#include <type_traits>

#include "bounds.hpp"
#include "speed/stopping.hpp"
#include "text/choice.hpp"

namespace safety_control_cloud {
namespace {

std::vector<std::string> not_finite(const Settings& settings) {
  std::vector<std::string> sentences;
  for_each_parameter(settings, [&](const char* name, const auto& value) {
    if constexpr (std::is_floating_point_v<std::decay_t<decltype(value)>>) {
      if (!std::isfinite(value)) sentences.push_back(std::string(name) + " must be finite");
    }
  });
  return sentences;
}

void check_bounds(const Settings& settings, Problems& problems) {
  for_each_parameter(settings, [&](const std::string& name, const auto& value) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>) {
      check_bound(name, static_cast<double>(value), problems);
    }
  });
}

/// What one room cannot see.
void check_together(const Settings& settings, Problems& problems) {
  problems.require(settings.limits.danger > settings.corridor.range_min, "danger_distance must be more than range_min");
  problems.require(settings.publish_rate >= 1.0 && settings.publish_rate <= 1000.0,
                   "publish_rate must lie between 1 and 1000");
}

}  // namespace

const char* name_of(InputKind input) { return input == InputKind::Depth ? "depth" : "cloud"; }

std::optional<InputKind> input_named(const std::string& name) {
  return choice_named(name, {InputKind::Cloud, InputKind::Depth});
}

std::vector<std::string> problems_in(const Settings& settings) {
  Problems problems{not_finite(settings)};
  check(static_cast<const LookSettings&>(settings), problems);
  check(static_cast<const DoubtSettings&>(settings), problems);
  check(static_cast<const MemorySettings&>(settings), problems);
  check(static_cast<const SpeedSettings&>(settings), problems);
  check_together(settings, problems);
  check_bounds(settings, problems);
  return problems.sentences;
}

std::vector<std::string> doubts_about(const Settings& settings) {
  return doubts_about_stopping(settings, settings.source_timeout);
}

}  // namespace safety_control_cloud
