// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

namespace safety_control_cloud {

void check(const DoubtSettings& doubt, Problems& problems) {
  problems.require(doubt.source_timeout > 0.0, "source_timeout must be positive");
  problems.require(doubt.stamp_tolerance >= 0.0, "stamp_tolerance must not be negative");
  problems.require(doubt.min_valid_ratio >= 0.0 && doubt.min_valid_ratio <= 1.0,
                   "min_valid_ratio must lie between 0 and 1");
  problems.require(doubt.min_returns >= 1, "min_returns must be at least 1");
  problems.require(doubt.frozen_clouds != 1, "frozen_clouds must be 0 (off) or at least 2");
}

}  // namespace safety_control_cloud
