// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "settings.hpp"

namespace safety_control_cloud {

/// [s] from an obstacle's appearing until the base brakes, at worst: it appears behind a cloud's being taken
/// (sensor_period), that cloud may be source_timeout old before it counts as stale, no other comes for source_timeout,
/// and the base obeys its last command for base_timeout.
double reaction_time(double source_timeout, const Stopping& stopping);

/// [m] driven from the moment an obstacle appears until the robot is down to the speed `to` [m/s]:
/// from x reaction_time + (from^2 - to^2) / (2 base_deceleration).
/// The idea is that of ISO 13855 (approach speed x overall response time + a braking distance); it is no proof under
/// it.
double slowing_distance(double from, double to, double source_timeout, const Stopping& stopping);

/// [m] until it stands.
double stopping_distance(double speed, double source_timeout, const Stopping& stopping);

/// What the robot cannot keep of these zones, each at the speed that it is entered with: Warning at safe_speed, Danger
/// at warning_speed.
///
/// It asks warning_distance, not danger_distance, to be enough to stop in from safe_speed. So danger_distance is for
/// what was seen in the Warning zone first: the tutorial's 0.5 m holds for 0.1 m/s (0.179 m, and 0.265 m of hull). What
/// appears within 0.651 m while the robot drives 0.2 m/s, as somebody who steps in from the side, may be hit: with a
/// camera that neither ages nor falls silent the robot needs 0.186 m and its hull, and with the tutorial's own figures
/// (no age) 0.286 m and its hull, which is more than 0.5 m.
std::vector<std::string> doubts_about_stopping(const SpeedSettings& speed, double source_timeout);

}  // namespace safety_control_cloud
