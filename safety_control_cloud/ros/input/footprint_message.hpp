// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PolygonStamped.h>

#include <string>

#include "../../core/guard/lists.hpp"

namespace safety_control_cloud {

/// The corners of a polygon in base_frame; their heights are not asked. Throws std::invalid_argument with what makes the
/// message none; whether it is a footprint, the settings know.
Lists footprint_in(const geometry_msgs::PolygonStamped& polygon, const std::string& base_frame);

}  // namespace safety_control_cloud
