// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "doubt/settings.hpp"
#include "guard/settings.hpp"
#include "look/settings.hpp"
#include "memory/settings.hpp"
#include "speed/settings.hpp"

namespace safety_control_cloud {

/// What the camera sends: from the same picture, both give the same Sight.
enum class InputKind : std::uint8_t {
  Cloud,  ///< points
  Depth,  ///< depth images
};

const char* name_of(InputKind input);  ///< "cloud" or "depth"
std::optional<InputKind> input_named(const std::string& name);

/// Every parameter with its default: the sum of what the rooms of the core need, and what the node itself does. Nowhere
/// else stands a default.
struct Settings : LookSettings, DoubtSettings, MemorySettings, SpeedSettings, GuardSettings {
  double publish_rate = 10.0;  ///< [Hz] at which a command goes out even if no cloud comes in
  InputKind input = InputKind::Cloud;
};

/// Calls visit(name, value) for every parameter, with the name it has in ROS, in YAML and in Python.
/// `settings` may be const; `visit` must take float, double, std::size_t, std::string, Lists, MinusInf, Method,
/// InputKind, Mode and CommandType.
template <class SettingsOrConst, class Visit>
void for_each_parameter(SettingsOrConst& settings, Visit visit) {
  for_each_look_parameter(settings, visit);
  for_each_doubt_parameter(settings, visit);
  for_each_memory_parameter(settings, visit);
  for_each_speed_parameter(settings, visit);
  for_each_guard_parameter(settings, visit);
  visit("publish_rate", settings.publish_rate);
  visit("input", settings.input);
}

/// Everything that makes these settings unfit to drive with, a sentence each; empty if they are fit.
std::vector<std::string> problems_in(const Settings& settings);

/// The settings that a sensor of the guard looks by: down a corridor in base_frame, as wide as the robot.
Settings sensor_settings(const Settings& settings);

/// What is fit but unwise: distances in which the robot could not stop.
std::vector<std::string> doubts_about(const Settings& settings);

}  // namespace safety_control_cloud
