// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "../input/kind.hpp"
#include "../text/problems.hpp"

namespace safety_control_cloud {

/// One of several sensors.
struct SensorSettings {
  std::string name;
  InputKind type = InputKind::Cloud;
  std::string topic;
  bool required = true;  ///< in doubt, it stops the robot; otherwise it then counts as not there

  /// Parameters, by their names, that are its own in place of those of all: see is_own_parameter().
  std::map<std::string, double> own = {};
};

using Sensors = std::vector<SensorSettings>;

bool operator==(const SensorSettings& a, const SensorSettings& b);

/// Whether a sensor of this type may have its own.
bool is_own_parameter(const std::string& name, InputKind type);

/// Of such a one, whether it is true or false: 1 or 0 in SensorSettings::own.
bool is_flag(const std::string& own_parameter);

void check(const Sensors& sensors, Problems& problems);

}  // namespace safety_control_cloud
