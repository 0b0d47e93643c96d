// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

namespace safety_control_cloud {

void check(const SpeedSettings& speed, Problems& problems) {
  problems.require(speed.limits.danger > 0.0, "danger_distance must be positive");
  problems.require(speed.limits.warning > speed.limits.danger, "warning_distance must be more than danger_distance");
  problems.require(speed.speeds.warning >= 0.0, "warning_speed must not be negative");
  problems.require(speed.speeds.safe >= speed.speeds.warning, "safe_speed must not be less than warning_speed");
  problems.require(speed.release.clouds >= 1, "release_clouds must be at least 1");
  problems.require(speed.release.time >= 0.0, "release_time must not be negative");
  problems.require(speed.stopping.sensor_period >= 0.0, "sensor_period must not be negative");
  problems.require(speed.stopping.base_timeout >= 0.0, "base_timeout must not be negative");
  problems.require(speed.stopping.base_deceleration > 0.0, "base_deceleration must be positive");
  problems.require(speed.stopping.hull >= 0.0, "hull must not be negative");
}

}  // namespace safety_control_cloud
