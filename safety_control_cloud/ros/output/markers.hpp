// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "../../core/decision.hpp"
#include "../../core/settings.hpp"

namespace safety_control_cloud {

/// What rviz shows of a decision: the corridor as a box in the zone's colour, the two limits as planes, the nearest
/// point as a sphere, zone and distance as text. In the target frame, or in the cloud's if there is none.
visualization_msgs::MarkerArray to_markers(const Decision& decision, const Settings& settings,
                                           const std_msgs::Header& cloud);

}  // namespace safety_control_cloud
