// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "corridor.hpp"
#include "speed.hpp"
#include "zone.hpp"

namespace safety_control_cloud {

/// How the corridor is searched: both give the same Sight.
enum class Method : std::uint8_t {
  OnePass,  ///< look(): one pass over the bytes
  Pcl,      ///< passthrough(): the tutorial's PCL filters, the specification
};

const char* name_of(Method method);  ///< "one_pass" or "pcl"
std::optional<Method> method_named(const std::string& name);

/// Every parameter with its default; the only place where a default stands.
struct Settings {
  Corridor corridor;
  ZoneLimits limits;
  Speeds speeds;
  Hold release;
  double source_timeout = 0.5;   ///< [s] without a cloud until the camera counts as silent
  double min_valid_ratio = 0.1;  ///< share of returns below which the sensor counts as blind
  double publish_rate = 10.0;    ///< [Hz] at which a command goes out even if no cloud comes in
  Method method = Method::OnePass;
};

/// Calls visit(name, value) for every parameter, with the name it has in ROS, in YAML and in Python.
/// `settings` may be const; `visit` must take float, double, std::size_t and Method.
template <class SettingsOrConst, class Visit>
void for_each_parameter(SettingsOrConst& settings, Visit visit) {
  visit("x_min", settings.corridor.x_min);
  visit("x_max", settings.corridor.x_max);
  visit("y_min", settings.corridor.y_min);
  visit("y_max", settings.corridor.y_max);
  visit("range_min", settings.corridor.range_min);
  visit("min_points", settings.corridor.min_points);
  visit("warning_distance", settings.limits.warning);
  visit("danger_distance", settings.limits.danger);
  visit("safe_speed", settings.speeds.safe);
  visit("warning_speed", settings.speeds.warning);
  visit("release_clouds", settings.release.clouds);
  visit("release_time", settings.release.time);
  visit("source_timeout", settings.source_timeout);
  visit("min_valid_ratio", settings.min_valid_ratio);
  visit("publish_rate", settings.publish_rate);
  visit("method", settings.method);
}

/// Everything that makes these settings unfit to drive with, a sentence each; empty if they are fit.
std::vector<std::string> problems_in(const Settings& settings);

}  // namespace safety_control_cloud
