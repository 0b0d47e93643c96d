// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "connected.hpp"
#include "near_pixels.hpp"

namespace safety_control_cloud {

/// All of a thing.
std::vector<NearPixels::Index> pixels_of(const NearPixels& found, const Stretches& all);

/// Those of a thing that touch others of it on all sides, and those of its parts too thin to have any; none if none
/// does. A rail that is joined to a leg is thin, and may be lost while the leg is seen to go.
std::vector<NearPixels::Index> inner_and_thin(const NearPixels& found, const Connected& connected,
                                              const Stretches& all);

}  // namespace safety_control_cloud
