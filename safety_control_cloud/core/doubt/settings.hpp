// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "../text/problems.hpp"

namespace safety_control_cloud {

/// When a camera is not believed.
struct DoubtSettings {
  double source_timeout = 0.5;    ///< [s] without a cloud until the camera counts as silent
  double stamp_tolerance = 1.0;   ///< [s] a stamp may be off from now; 0 = any
  double min_valid_ratio = 0.1;   ///< share of returns, and of lately's, below which the sensor counts as blind
  std::size_t min_returns = 1;    ///< with fewer returns it counts as blind, whatever their share
  std::size_t frozen_clouds = 0;  ///< so many successive clouds with the same content are a frozen camera; 0 = off
};

/// Calls visit(name, value) for every parameter; `doubt` may be const.
template <class DoubtSettingsOrConst, class Visit>
void for_each_doubt_parameter(DoubtSettingsOrConst& doubt, Visit& visit) {
  visit("source_timeout", doubt.source_timeout);
  visit("stamp_tolerance", doubt.stamp_tolerance);
  visit("min_valid_ratio", doubt.min_valid_ratio);
  visit("min_returns", doubt.min_returns);
  visit("frozen_clouds", doubt.frozen_clouds);
}

void check(const DoubtSettings& doubt, Problems& problems);

}  // namespace safety_control_cloud
