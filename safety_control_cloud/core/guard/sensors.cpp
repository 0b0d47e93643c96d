// SPDX-License-Identifier: BSD-3-Clause
#include "sensors.hpp"

#include <cmath>
#include <set>

#include "../text/words.hpp"

namespace safety_control_cloud {
namespace {

const std::set<std::string> of_all = {"source_timeout", "stamp_tolerance", "min_valid_ratio", "min_returns",
                                      "frozen_clouds",  "sensor_period",   "min_points",      "noise"};
const std::set<std::string> of_cameras = {"range_min", "near_loss_distance", "near_loss_timeout", "blind_range"};
const std::set<std::string> flags_of_scans = {"inf_is_free", "zero_is_inf"};
const std::set<std::string> counts = {"min_returns", "frozen_clouds", "min_points"};

}  // namespace

bool operator==(const SensorSettings& a, const SensorSettings& b) {
  return a.name == b.name && a.type == b.type && a.topic == b.topic && a.required == b.required && a.own == b.own;
}

bool is_own_parameter(const std::string& name, InputKind type) {
  return of_all.count(name) > 0 || (type == InputKind::Scan ? flags_of_scans : of_cameras).count(name) > 0;
}

bool is_flag(const std::string& own_parameter) { return flags_of_scans.count(own_parameter) > 0; }

void check(const Sensors& sensors, Problems& problems) {
  std::set<std::string> names, topics;
  for (const SensorSettings& sensor : sensors) {
    problems.require(is_name(sensor.name), words("sensors: \"", sensor.name, "\" is no name: letters, digits and _"));
    problems.require(names.insert(sensor.name).second, "sensors: two are named " + sensor.name);
    problems.require(!sensor.topic.empty(), words("sensors, ", sensor.name, ": topic must not be empty"));
    problems.require(topics.insert(sensor.topic).second, "sensors: two have the topic " + sensor.topic);
    for (const auto& [parameter, value] : sensor.own) {
      problems.require(
          is_own_parameter(parameter, sensor.type),
          words("sensors, ", sensor.name, ": a ", name_of(sensor.type), " has no ", parameter, " of its own"));
      problems.require(counts.count(parameter) == 0 || (value >= 0.0 && std::floor(value) == value),
                       words("sensors, ", sensor.name, ": ", parameter, " must be a whole number"));
    }
  }
}

}  // namespace safety_control_cloud
