// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "near_ground.hpp"
#include "thing.hpp"

namespace safety_control_cloud {

/// Tells the near ground of the things that are seen in the same picture, of which only those in the same distance
/// count; of each spot of theirs, whether what it shows stands on the near floor: the thing reaches down to it in this
/// column without a gap.
void place_on_ground(std::vector<Thing>& things, NearGround& ground, const Pixels& picture, const Outlook& outlook);

}  // namespace safety_control_cloud
