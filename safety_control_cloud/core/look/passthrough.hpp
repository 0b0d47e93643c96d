// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "look.hpp"

namespace safety_control_cloud {

/// look() the tutorial's way, with PCL: PassThrough on y, then on x, then getMinMax3D. This is the specification that
/// look() must equal in every bit. A PassThrough on z comes first, because PCL counts (0, 0, 0), "no return" of real
/// sensors, as an obstacle at distance 0; what it drops (-Inf among it) is counted before.
Sight passthrough(const View& view, const Outlook& outlook, Crop crop = Crop::Skip, Rows rows = Rows::Joined);

}  // namespace safety_control_cloud
