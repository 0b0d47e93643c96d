// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

#include <cmath>
#include <tuple>
#include <type_traits>

namespace safety_control_cloud {
namespace {

/// Collects a sentence for every requirement that does not hold. Requirements are written so that NaN fails them.
struct Problems {
  std::vector<std::string> sentences;

  void require(bool holds, const char* sentence) {
    if (!holds) sentences.emplace_back(sentence);
  }
};

std::vector<std::string> not_finite(const Settings& settings) {
  std::vector<std::string> sentences;
  for_each_parameter(settings, [&](const char* name, const auto& value) {
    if constexpr (std::is_floating_point_v<std::decay_t<decltype(value)>>) {
      if (!std::isfinite(value)) sentences.push_back(std::string(name) + " must be finite");
    }
  });
  return sentences;
}

}  // namespace

const char* name_of(Method method) { return method == Method::Pcl ? "pcl" : "one_pass"; }

std::optional<Method> method_named(const std::string& name) {
  for (const Method method : {Method::OnePass, Method::Pcl}) {
    if (name == name_of(method)) return method;
  }
  return std::nullopt;
}

std::vector<std::string> problems_in(const Settings& settings) {
  const auto& [corridor, limits, speeds] = std::tie(settings.corridor, settings.limits, settings.speeds);
  Problems problems{not_finite(settings)};
  problems.require(corridor.x_min < corridor.x_max, "x_min must be less than x_max");
  problems.require(corridor.y_min < corridor.y_max, "y_min must be less than y_max");
  problems.require(corridor.range_min >= 0.0f, "range_min must not be negative");
  problems.require(corridor.min_points >= 1, "min_points must be at least 1");
  problems.require(limits.danger > 0.0, "danger_distance must be positive");
  problems.require(limits.danger > corridor.range_min, "danger_distance must be more than range_min");
  problems.require(limits.warning > limits.danger, "warning_distance must be more than danger_distance");
  problems.require(speeds.warning >= 0.0, "warning_speed must not be negative");
  problems.require(speeds.safe >= speeds.warning, "safe_speed must not be less than warning_speed");
  problems.require(settings.release.clouds >= 1, "release_clouds must be at least 1");
  problems.require(settings.release.time >= 0.0, "release_time must not be negative");
  problems.require(settings.source_timeout > 0.0, "source_timeout must be positive");
  problems.require(settings.min_valid_ratio >= 0.0 && settings.min_valid_ratio <= 1.0,
                   "min_valid_ratio must lie between 0 and 1");
  problems.require(settings.publish_rate >= 1.0 && settings.publish_rate <= 1000.0,
                   "publish_rate must lie between 1 and 1000");
  return problems.sentences;
}

}  // namespace safety_control_cloud
