// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace safety_control_cloud {

/// What passes between an obstacle's appearing and the robot's standing, in the worst case.
struct Stopping {
  double sensor_period = 0.05;      ///< [s] between two clouds (20 Hz)
  double base_timeout = 0.6;        ///< [s] after its last command in which the base still obeys it (Kobuki)
  double base_deceleration = 0.36;  ///< [m/s2] of the base when it brakes (Kobuki's driver)
};

/// [m] driven from the moment an obstacle appears until the robot stands:
/// speed x (sensor_period + source_timeout + base_timeout) + speed^2 / (2 base_deceleration).
/// The idea is that of ISO 13855 (approach speed x overall response time + a braking distance); it is no proof under
/// it.
double stopping_distance(double speed, double source_timeout, const Stopping& stopping);

}  // namespace safety_control_cloud
