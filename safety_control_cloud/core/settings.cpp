// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

#include <cmath>
#include <initializer_list>
#include <sstream>
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

void check_corridor(const Settings& settings, Problems& problems) {
  const Corridor& corridor = settings.corridor;
  const FrameCorridor& in_frame = settings.frame_corridor;
  problems.require(corridor.x_min < corridor.x_max, "x_min must be less than x_max");
  problems.require(corridor.y_min < corridor.y_max, "y_min must be less than y_max");
  problems.require(in_frame.left > -in_frame.right, "left and right must leave a corridor between them");
  problems.require(in_frame.bottom < in_frame.top, "bottom must be less than top");
  problems.require(corridor.range_min >= 0.0f, "range_min must not be negative");
  problems.require(corridor.min_points >= 1, "min_points must be at least 1");
}

bool same_limits(const Corridor& a, const Corridor& b) {
  return a.x_min == b.x_min && a.x_max == b.x_max && a.y_min == b.y_min && a.y_max == b.y_max;
}

bool same_limits(const FrameCorridor& a, const FrameCorridor& b) {
  return a.left == b.left && a.right == b.right && a.bottom == b.bottom && a.top == b.top;
}

/// The limits that do not apply must stand at their defaults: whoever set them meant something else than will happen.
void check_axes(const Settings& settings, Problems& problems) {
  if (settings.target_frame.empty()) {
    problems.require(same_limits(settings.frame_corridor, FrameCorridor{}),
                     "left, right, bottom and top need a target_frame; without one the corridor is x_min, x_max, y_min "
                     "and y_max in the camera's optical frame");
  } else {
    problems.require(same_limits(settings.corridor, Corridor{}),
                     "x_min, x_max, y_min and y_max lie in the camera's optical frame; with target_frame the corridor "
                     "is left, right, bottom and top");
  }
}

void check_zones(const Settings& settings, Problems& problems) {
  problems.require(settings.limits.danger > 0.0, "danger_distance must be positive");
  problems.require(settings.limits.danger > settings.corridor.range_min, "danger_distance must be more than range_min");
  problems.require(settings.limits.warning > settings.limits.danger,
                   "warning_distance must be more than danger_distance");
  problems.require(settings.speeds.warning >= 0.0, "warning_speed must not be negative");
  problems.require(settings.speeds.safe >= settings.speeds.warning, "safe_speed must not be less than warning_speed");
  problems.require(settings.release.clouds >= 1, "release_clouds must be at least 1");
  problems.require(settings.release.time >= 0.0, "release_time must not be negative");
}

void check_sensor(const Settings& settings, Problems& problems) {
  const auto& [source_timeout, stamp_tolerance] = std::tie(settings.source_timeout, settings.stamp_tolerance);
  problems.require(source_timeout > 0.0, "source_timeout must be positive");
  problems.require(stamp_tolerance >= 0.0, "stamp_tolerance must not be negative");
  problems.require(settings.min_valid_ratio >= 0.0 && settings.min_valid_ratio <= 1.0,
                   "min_valid_ratio must lie between 0 and 1");
  problems.require(settings.near_loss.distance >= 0.0 && settings.near_loss.distance <= PixelMemory::farthest,
                   "near_loss_distance must lie between 0 and 2.7");
  problems.require(settings.near_loss.timeout >= 0.0, "near_loss_timeout must not be negative");
  problems.require(settings.frozen_clouds != 1, "frozen_clouds must be 0 (off) or at least 2");
  problems.require(settings.stopping.sensor_period >= 0.0, "sensor_period must not be negative");
  problems.require(settings.stopping.base_timeout >= 0.0, "base_timeout must not be negative");
  problems.require(settings.stopping.base_deceleration > 0.0, "base_deceleration must be positive");
  problems.require(settings.publish_rate >= 1.0 && settings.publish_rate <= 1000.0,
                   "publish_rate must lie between 1 and 1000");
}

template <class Choice>
std::optional<Choice> choice_named(const std::string& name, std::initializer_list<Choice> choices) {
  for (const Choice choice : choices) {
    if (name == name_of(choice)) return choice;
  }
  return std::nullopt;
}

}  // namespace

const char* name_of(Method method) { return method == Method::Pcl ? "pcl" : "one_pass"; }

std::optional<Method> method_named(const std::string& name) {
  return choice_named(name, {Method::OnePass, Method::Pcl});
}

const char* name_of(Input input) { return input == Input::Depth ? "depth" : "cloud"; }

std::optional<Input> input_named(const std::string& name) { return choice_named(name, {Input::Cloud, Input::Depth}); }

Corridor corridor_of(const Settings& settings) {
  Corridor corridor = settings.corridor;
  if (settings.target_frame.empty()) return corridor;
  corridor.x_min = static_cast<float>(-settings.frame_corridor.left);
  corridor.x_max = static_cast<float>(settings.frame_corridor.right);
  corridor.y_min = static_cast<float>(-settings.frame_corridor.top);
  corridor.y_max = static_cast<float>(-settings.frame_corridor.bottom);
  return corridor;
}

std::vector<std::string> problems_in(const Settings& settings) {
  Problems problems{not_finite(settings)};
  check_corridor(settings, problems);
  check_axes(settings, problems);
  check_zones(settings, problems);
  check_sensor(settings, problems);
  return problems.sentences;
}

std::vector<std::string> doubts_about(const Settings& settings) {
  const double needed = stopping_distance(settings.speeds.safe, settings.source_timeout, settings.stopping);
  if (settings.limits.danger >= needed) return {};
  std::ostringstream sentence;
  sentence << "danger_distance " << settings.limits.danger << " m is shorter than the " << needed
           << " m in which the robot may stop: safe_speed x (sensor_period + source_timeout + base_timeout)"
              " + safe_speed^2 / (2 base_deceleration), after the idea of ISO 13855";
  return {sentence.str()};
}

}  // namespace safety_control_cloud
