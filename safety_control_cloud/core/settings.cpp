// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

#include <algorithm>
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

/// Lengths that the guard takes from the footprint; whoever set them meant something else than will happen.
void check_guard(const Settings& settings, Problems& problems) {
  const FrameCorridor defaults;
  const FrameCorridor& given = settings.frame_corridor;
  problems.require(settings.target_frame.empty(), "in mode guard the frame is base_frame, not target_frame");
  problems.require(given.left == defaults.left && given.right == defaults.right,
                   "in mode guard the footprint says what left and right say in mode drive");
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
  const bool guards = settings.mode == Mode::Guard;
  if (guards) check_guard(settings, problems);
  check(static_cast<const LookSettings&>(guards ? sensor_settings(settings) : settings), problems);
  check(static_cast<const DoubtSettings&>(settings), problems);
  check(static_cast<const MemorySettings&>(settings), problems);
  check(static_cast<const SpeedSettings&>(settings), problems);
  check(static_cast<const GuardSettings&>(settings), problems);
  check_together(settings, problems);
  check_bounds(settings, problems);
  return problems.sentences;
}

Settings sensor_settings(const Settings& settings) {
  Settings sensor = settings;
  const Footprint footprint = footprint_of(settings);
  double front = footprint.radius, left = front, right = front;
  for (const Point2& corner : footprint.polygon) {
    front = std::max(front, corner.x);
    left = std::max(left, corner.y), right = std::max(right, -corner.y);
  }
  sensor.target_frame = settings.base_frame;
  sensor.frame_corridor.left = left + footprint.margin;
  sensor.frame_corridor.right = right + footprint.margin;
  sensor.limits = {front + settings.limits.warning, front + settings.limits.danger};
  return sensor;
}

std::vector<std::string> doubts_about(const Settings& settings) {
  if (settings.mode == Mode::Guard) return {};  // its speed follows from the distance
  return doubts_about_stopping(settings, settings.source_timeout);
}

}  // namespace safety_control_cloud
