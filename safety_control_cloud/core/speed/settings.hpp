// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "../text/problems.hpp"

namespace safety_control_cloud {

struct ZoneLimits {
  double warning = 1.0;  ///< [m] along z; farther is Safe
  double danger = 0.5;   ///< [m] along z; at this distance or nearer is Danger
};

struct Speeds {
  double safe = 0.2;     ///< [m/s] forward in the Safe zone
  double warning = 0.1;  ///< [m/s] forward in the Warning zone
};

/// How long a better zone must last before it is believed.
struct Hold {
  std::size_t clouds = 1;  ///< successive clouds that show it
  double time = 0.0;       ///< [s] since the first of them
};

/// What passes between an obstacle's appearing and the robot's standing, in the worst case.
struct Stopping {
  double sensor_period = 0.05;      ///< [s] between two clouds (20 Hz)
  double base_timeout = 0.6;        ///< [s] after its last command in which the base still obeys it (Kobuki)
  double base_deceleration = 0.36;  ///< [m/s2] of the base when it brakes (Kobuki's driver)
  double hull = 0.265;              ///< [m] that the robot sticks out before the camera (a TurtleBot: 0.178 + 0.087)
};

/// How fast the robot may go before what it sees.
struct SpeedSettings {
  ZoneLimits limits;
  Speeds speeds;
  Hold release;
  Stopping stopping;
};

/// Calls visit(name, value) for every parameter; `speed` may be const.
template <class SpeedSettingsOrConst, class Visit>
void for_each_speed_parameter(SpeedSettingsOrConst& speed, Visit& visit) {
  visit("warning_distance", speed.limits.warning);
  visit("danger_distance", speed.limits.danger);
  visit("safe_speed", speed.speeds.safe);
  visit("warning_speed", speed.speeds.warning);
  visit("release_clouds", speed.release.clouds);
  visit("release_time", speed.release.time);
  visit("sensor_period", speed.stopping.sensor_period);
  visit("base_timeout", speed.stopping.base_timeout);
  visit("base_deceleration", speed.stopping.base_deceleration);
  visit("hull", speed.stopping.hull);
}

void check(const SpeedSettings& speed, Problems& problems);

}  // namespace safety_control_cloud
