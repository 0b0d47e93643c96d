// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "../../core/guard_control.hpp"

namespace safety_control_cloud {

/// What rviz shows of an answer, in base_frame: the footprint with its margin, what it sweeps until the robot stands if
/// it is told to stop, the point that decided, and why.
visualization_msgs::MarkerArray to_markers(const Guarded& answer, const Settings& settings);

}  // namespace safety_control_cloud
