// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "zone.hpp"

namespace safety_control_cloud {

/// [m/s] forward. In Danger it is 0 and no setting changes that.
double speed_for(Zone zone, const Speeds& speeds);

}  // namespace safety_control_cloud
