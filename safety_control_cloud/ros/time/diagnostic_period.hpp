// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace safety_control_cloud {

/// Of how many seconds ~diagnostic_period may be.
constexpr bool is_diagnostic_period(double seconds) { return seconds > 0.0 && seconds <= 3600.0; }

}  // namespace safety_control_cloud
