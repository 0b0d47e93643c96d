// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "../look/outlook.hpp"
#include "loss.hpp"
#include "remembered.hpp"

namespace safety_control_cloud {

/// What is lost counts if it is so near to the camera [m].
struct KeptWithin {
  double distance;
  double may_be_nearer;  ///< so near it may have come nearer since, to where the sensor is blind
};

/// The nearest of the things of which anything is lost in the corridor.
std::optional<Loss> nearest_loss(const std::vector<Remembered>& things, const Outlook& outlook,
                                 const KeptWithin& within);

/// Of all of them.
std::vector<LostSpot> lost_spots(const std::vector<Remembered>& things, const Outlook& outlook,
                                 const KeptWithin& within);

/// Of two, what stops the robot sooner.
std::optional<Loss> nearer(const std::optional<Loss>& one, const std::optional<Loss>& other);

/// What stands lower than the corridor, and is seen to.
bool is_in_sight(const Loss& loss);

}  // namespace safety_control_cloud
