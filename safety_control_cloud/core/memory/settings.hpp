// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../text/problems.hpp"

namespace safety_control_cloud {

/// What is kept of what came near.
struct NearLossLimits {
  double distance = 0.75;  ///< [m] an obstacle seen nearer than this is kept when it stops returning; 0 = off
  double timeout = 0.0;    ///< [s] after which it is forgotten all the same; 0 = never

  /// [m] nearer than this the sensor returns nothing. What comes so near is kept, whatever `distance` is.
  double blind_range = 0.4;

  /// The robot does while anything is lost that may be too near to be seen, so that its picture rests; not a guard's.
  bool stands = true;

  static constexpr double farthest = 2.7;  ///< [m] that the distance may be
};

struct MemorySettings {
  NearLossLimits near_loss;
};

/// Calls visit(name, value) for every parameter; `memory` may be const.
template <class MemorySettingsOrConst, class Visit>
void for_each_memory_parameter(MemorySettingsOrConst& memory, Visit& visit) {
  visit("near_loss_distance", memory.near_loss.distance);
  visit("near_loss_timeout", memory.near_loss.timeout);
  visit("blind_range", memory.near_loss.blind_range);
}

void check(const MemorySettings& memory, Problems& problems);

}  // namespace safety_control_cloud
