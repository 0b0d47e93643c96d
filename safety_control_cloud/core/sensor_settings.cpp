// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <type_traits>

#include "guard/silhouette.hpp"
#include "settings.hpp"

namespace safety_control_cloud {
namespace {

constexpr double greatest_count = 2147483647.0;

}  // namespace

Sensors sensors_of(const Settings& settings) {
  if (!settings.sensors.empty()) return settings.sensors;
  return {SensorSettings{name_of(settings.input), settings.input, "", true, {}}};
}

Settings own_settings(const Settings& settings, const SensorSettings& sensor) {
  Settings own = settings;
  own.sensors.clear();
  own.switches.clear();
  own.input = sensor.type;
  for_each_parameter(own, [&]([[maybe_unused]] const char* name, auto& setting) {  // g++ 9 sees no use of it
    using Value = std::decay_t<decltype(setting)>;
    if constexpr (std::is_arithmetic_v<Value>) {
      const auto found = sensor.own.find(name);
      if (found == sensor.own.end()) return;
      const bool fits = std::is_floating_point_v<Value> || (found->second >= 0.0 && found->second <= greatest_count);
      setting = fits ? static_cast<Value>(found->second) : std::numeric_limits<Value>::max();  // which is refused
    }
  });
  return own;
}

Settings sensor_settings(const Settings& own, double facing) {
  Settings sensor = own;
  const Footprint footprint = footprint_of(own);
  const Silhouette robot = silhouette_of(footprint, facing);
  sensor.target_frame = own.base_frame;
  sensor.frame_corridor.left = robot.left + footprint.margin;
  sensor.frame_corridor.right = robot.right + footprint.margin;
  sensor.limits = {robot.front + own.limits.warning, robot.front + own.limits.danger};
  sensor.near_loss.stands = false;
  if (own.input == InputKind::Scan) {  // it measures from range_min on, to all sides
    sensor.corridor.range_min = std::numeric_limits<float>::lowest();
    sensor.near_loss.distance = 0.0;
  }
  return sensor;
}

Law law_of(const Settings& own) {
  Law law;
  law.sensor_period = own.stopping.sensor_period;
  law.latency = own.latency;
  law.base_reaction = own.base_reaction;
  law.linear_deceleration = own.stopping.base_deceleration;
  law.angular_deceleration = own.angular_deceleration;
  law.obstacle_speed = own.obstacle_speed;
  law.escape_speed = own.escape_speed;
  law.noise = own.noise;
  law.min_points = own.corridor.min_points;
  return law;
}

}  // namespace safety_control_cloud
