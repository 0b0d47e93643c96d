// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../look/outlook.hpp"
#include "pixels.hpp"

namespace safety_control_cloud {

/// What finding near things starts from.
struct NearSearch {
  const Pixels& picture;
  const Outlook& outlook;
  const std::vector<float>& nearest_in_row;  ///< [m] in the corridor's axes; infinity where nothing is in the corridor
  float distance = 0.0f;                     ///< [m] ahead of the camera; what is nearer is near
  std::size_t least_pixels = 1;              ///< fewer are noise
  /// A cell holds one point at most, so that a thing takes as many however far away it is.
  bool sparse = false;
};

}  // namespace safety_control_cloud
