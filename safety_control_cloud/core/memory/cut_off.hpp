// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../look/outlook.hpp"
#include "pixels.hpp"

namespace safety_control_cloud {

/// Whether something recedes from the picture's lower border upward at half the rate of what is level, or more, as the
/// top of a low box does once the camera looks over its front; a wall does not. Of a camera that looks up or down, or
/// rolls, the rows' middle is where it looks level. `nearest_in_row` [m], infinity where nothing is in the corridor.
bool recedes_at_the_bottom(const Pixels& picture, const std::vector<float>& nearest_in_row);

/// Where that meets the border, in the corridor, in the cloud's frame: of a large picture, some of its columns.
std::vector<Point> ends_at_the_bottom(const Pixels& picture, const Outlook& outlook);

}  // namespace safety_control_cloud
