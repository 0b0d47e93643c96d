// SPDX-License-Identifier: BSD-3-Clause
#include "stopping.hpp"

#include "../text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr const char* rule =
    " speed x (sensor_period + 2 source_timeout + base_timeout) + speed^2 / (2 base_deceleration) + hull, after the "
    "idea"
    " of ISO 13855";

}  // namespace

double reaction_time(double source_timeout, const Stopping& stopping) {
  const double oldest = source_timeout;  // an older cloud is STALE
  return stopping.sensor_period + oldest + source_timeout + stopping.base_timeout;
}

double slowing_distance(double from, double to, double source_timeout, const Stopping& stopping) {
  return from * reaction_time(source_timeout, stopping) + (from * from - to * to) / (2.0 * stopping.base_deceleration);
}

double stopping_distance(double speed, double source_timeout, const Stopping& stopping) {
  return slowing_distance(speed, 0.0, source_timeout, stopping);
}

std::vector<std::string> doubts_about_stopping(const SpeedSettings& speed, double source_timeout) {
  const ZoneLimits& limits = speed.limits;
  const Speeds& speeds = speed.speeds;
  const Stopping& stopping = speed.stopping;
  std::vector<std::string> doubts;
  const auto check_entering = [&](const char* limit, double distance, const char* name, double entered_with) {
    const double needed = stopping_distance(entered_with, source_timeout, stopping) + stopping.hull;
    if (distance >= needed) return;
    doubts.push_back(words(limit, " ", distance, " m is shorter than the ", needed,
                           " m in which the robot may stop from ", name, " ", entered_with, " m/s:", rule));
  };
  check_entering("warning_distance", limits.warning, "safe_speed", speeds.safe);
  check_entering("danger_distance", limits.danger, "warning_speed", speeds.warning);
  const double needed = slowing_distance(speeds.safe, speeds.warning, source_timeout, stopping);
  if (limits.warning - limits.danger < needed) {
    doubts.push_back(words("warning_distance ", limits.warning, " m lies less than ", needed,
                           " m before danger_distance ", limits.danger,
                           " m: the robot may come to it faster than with warning_speed"));
  }
  return doubts;
}

}  // namespace safety_control_cloud
