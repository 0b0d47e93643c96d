// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

namespace safety_control_cloud {

void check(const MemorySettings& memory, Problems& problems) {
  problems.require(memory.near_loss.distance >= 0.0 && memory.near_loss.distance <= NearLossLimits::farthest,
                   "near_loss_distance must lie between 0 and 2.7");
  problems.require(memory.near_loss.timeout >= 0.0, "near_loss_timeout must not be negative");
  problems.require(memory.near_loss.blind_range >= 0.0 && memory.near_loss.blind_range <= 2.5,
                   "blind_range must lie between 0 and 2.5");
}

}  // namespace safety_control_cloud
