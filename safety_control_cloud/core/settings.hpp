// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "doubt/settings.hpp"
#include "guard/given.hpp"
#include "guard/settings.hpp"
#include "input/kind.hpp"
#include "look/settings.hpp"
#include "memory/settings.hpp"
#include "speed/law.hpp"
#include "speed/settings.hpp"

namespace safety_control_cloud {

/// Every parameter with its default: the sum of what the rooms of the core need, and what the node itself does. Nowhere
/// else stands a default.
struct Settings : LookSettings, DoubtSettings, MemorySettings, SpeedSettings, GuardSettings {
  double publish_rate = 10.0;  ///< [Hz] at which a command goes out even if no cloud comes in
  InputKind input = InputKind::Cloud;
};

/// Calls visit(name, value) for every parameter, with the name it has in ROS, in YAML and in Python.
/// `settings` may be const; `visit` must take bool, float, double, std::size_t, std::string, Lists, Sensors, Switches,
/// MinusInf, Method, InputKind, Mode and CommandType.
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

/// The guard's sensors: those of the list, or the one of `input`, which has no topic of its own.
Sensors sensors_of(const Settings& settings);

/// The settings with what is this sensor's own.
Settings own_settings(const Settings& settings, const SensorSettings& sensor);

/// Of own_settings() those that the sensor looks by: down a corridor as wide as the robot that leads, in base_frame,
/// into the direction [rad] in which it looks.
Settings sensor_settings(const Settings& own, double facing = 0.0);

/// Of own_settings() those by which what the sensor shows is judged.
Law law_of(const Settings& own);

/// How the base follows what the guard gives.
Following following_of(const Settings& settings);

/// [s] after which the guard is to give a new answer, though nobody says anything: data grow older, and the law counts
/// on an answer no later than the next look, of what a sensor shows and of what its looks left behind.
double answer_period(const Settings& settings);

/// What is fit but unwise: distances in which the robot could not stop; as a guard, looks or commands too far apart.
std::vector<std::string> doubts_about(const Settings& settings);

}  // namespace safety_control_cloud
