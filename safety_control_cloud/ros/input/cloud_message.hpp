// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "../../core/input/reading.hpp"

namespace safety_control_cloud {

/// The points of a message, borrowed from it, or why they cannot be read.
Reading view_of(const sensor_msgs::PointCloud2& cloud);

}  // namespace safety_control_cloud
