// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/duration.h>

namespace safety_control_cloud {

/// roscpp sends from a thread of its own, and drops what waits there when a topic is closed: gives it time.
inline void let_it_leave() { ros::WallDuration(0.1).sleep(); }

}  // namespace safety_control_cloud
