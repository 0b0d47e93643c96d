// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "bounds.hpp"
#include "speed/stopping.hpp"
#include "text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double least_answer_period = 0.01;  // [s]

std::vector<std::string> not_finite(const Settings& settings) {
  std::vector<std::string> sentences;
  for_each_parameter(settings, [&]([[maybe_unused]] const char* name, const auto& value) {
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
  problems.require(
      same_limits(settings.corridor, Corridor{}),
      "in mode guard the footprint, bottom and top say what x_min, x_max, y_min and y_max say in mode drive");
}

/// Without what is no matter of the settings, or said already: what a scan is looked by, how wide the footprint is.
Settings looked_by(Settings settings) {
  settings.input = InputKind::Cloud;
  if (settings.base_frame.empty()) settings.base_frame = GuardSettings{}.base_frame;
  Corridor& corridor = settings.corridor;
  const Corridor defaults;
  corridor.x_min = defaults.x_min, corridor.x_max = defaults.x_max;
  corridor.y_min = defaults.y_min, corridor.y_max = defaults.y_max;
  Settings looked = sensor_settings(settings);
  looked.frame_corridor.left = FrameCorridor{}.left, looked.frame_corridor.right = FrameCorridor{}.right;
  return looked;
}

/// What of a sensor is unfit only by what is its own.
void check_own(const Settings& settings, const SensorSettings& sensor, Problems& problems) {
  const std::size_t of_all = problems.sentences.size();
  for (const std::string& problem : problems_in(own_settings(settings, sensor))) {
    const auto end = problems.sentences.begin() + static_cast<std::ptrdiff_t>(of_all);
    const bool said = std::find(problems.sentences.begin(), end, problem) != end;
    problems.require(said, "sensors, " + sensor.name + ": " + problem);
  }
}

/// What one room cannot see.
void check_together(const Settings& settings, Problems& problems) {
  problems.require(settings.limits.danger > settings.corridor.range_min, "danger_distance must be more than range_min");
  problems.require(settings.mode == Mode::Guard || settings.sensors.empty(), "sensors are of mode guard");
  problems.require(settings.mode == Mode::Guard || settings.switches.empty(), "switches are of mode guard");
  problems.require(settings.mode == Mode::Guard || settings.input != InputKind::Scan,
                   "input scan is of mode guard: the drive mode looks ahead with a camera");
  problems.require(settings.publish_rate >= 1.0 && settings.publish_rate <= 1000.0,
                   "publish_rate must lie between 1 and 1000");
}

/// Its speed follows from the distance, but it is to hear and to be heard often enough.
std::vector<std::string> doubts_about_guard(const Settings& settings) {
  std::vector<std::string> sentences;
  const auto listen = [&](const Settings& own, const std::string& name) {
    const double period = own.stopping.sensor_period;
    if (own.source_timeout >= period) return;
    sentences.push_back(words(name, "source_timeout ", measured(own.source_timeout, "s"),
                              " is less than sensor_period ", measured(period, "s"),
                              ": it counts as silent between one look and the next"));
  };
  if (settings.sensors.empty()) listen(settings, "");
  for (const SensorSettings& sensor : settings.sensors)
    listen(own_settings(settings, sensor), "sensors, " + sensor.name + ": ");
  const double apart = answer_period(settings), base_timeout = settings.stopping.base_timeout;
  if (apart > base_timeout && base_timeout > 0.0)
    sentences.push_back(words("at this sensor_period and publish_rate ", settings.publish_rate, " commands may be ",
                              measured(apart, "s"), " apart, and after base_timeout ", measured(base_timeout, "s"),
                              " the base stops"));
  return sentences;
}

}  // namespace

std::vector<std::string> problems_in(const Settings& settings) {
  Problems problems{not_finite(settings)};
  const bool guards = settings.mode == Mode::Guard;
  if (guards) check_guard(settings, problems);
  check(static_cast<const LookSettings&>(guards ? looked_by(settings) : settings), problems);
  check(static_cast<const DoubtSettings&>(settings), problems);
  check(static_cast<const MemorySettings&>(settings), problems);
  check(static_cast<const SpeedSettings&>(settings), problems);
  check(static_cast<const GuardSettings&>(settings), problems);
  check_together(settings, problems);
  check_bounds(settings, problems);
  for (const SensorSettings& sensor : settings.sensors) check_own(settings, sensor, problems);
  return problems.sentences;
}

Following following_of(const Settings& settings) {
  return {settings.latency + settings.base_reaction, settings.stopping.base_deceleration,
          settings.angular_deceleration};
}

double answer_period(const Settings& settings) {
  double period = std::min(1.0 / settings.publish_rate, settings.stopping.sensor_period);
  for (const SensorSettings& sensor : settings.sensors)
    period = std::min(period, own_settings(settings, sensor).stopping.sensor_period);
  return std::max(least_answer_period, period);
}

std::vector<std::string> doubts_about(const Settings& settings) {
  if (settings.mode == Mode::Guard) return doubts_about_guard(settings);
  return doubts_about_stopping(settings, settings.source_timeout);
}

}  // namespace safety_control_cloud
