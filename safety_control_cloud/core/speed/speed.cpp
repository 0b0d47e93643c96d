// SPDX-License-Identifier: BSD-3-Clause
#include "speed.hpp"

namespace safety_control_cloud {

double speed_for(Zone zone, const Speeds& speeds) {
  if (zone == Zone::Safe) return speeds.safe;
  if (zone == Zone::Warning) return speeds.warning;
  return 0.0;
}

}  // namespace safety_control_cloud
