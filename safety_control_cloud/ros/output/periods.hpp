// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace safety_control_cloud {

inline constexpr double log_period = 1.0;      ///< [s] between two lines that say the same
inline constexpr double markers_period = 0.1;  ///< [s] rviz needs no more

}  // namespace safety_control_cloud
