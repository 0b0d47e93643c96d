// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "decision.hpp"
#include "sensor.hpp"
#include "unplaced.hpp"

namespace safety_control_cloud {

/// Of the nearest obstacle; Safe if nothing is seen.
Zone zone_of(const Sight& sight, const ZoneLimits& limits);

/// To stand, for this doubt; `counted` is what the latest reading held.
Decision standing_for(const Doubt& doubt, const Sight& counted);

/// The same for what is unplaced, of which there is some.
Decision standing_for(const Unplaced& unplaced, const Sight& counted);

/// What one sensor by itself lets the robot do: the zone and why, before any latch; the speed is left at 0.
Decision verdict_on(const Sensor& sensor, const ZoneLimits& limits);

}  // namespace safety_control_cloud
