// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../input/runs.hpp"
#include "outlook.hpp"
#include "places.hpp"
#include "sight.hpp"

namespace safety_control_cloud {

/// Looks down the corridor in one pass over the view's bytes. Where rows are to be told apart, it says what is nearest
/// in each.
Sight look(const View& view, const Outlook& outlook, Crop crop = Crop::Skip, Rows rows = Rows::Joined);

/// look() with something alongside, if there is anything, in the same pass.
Sight look_alongside(const View& view, const Outlook& outlook, Crop crop, Rows rows, const Alongside* alongside);

}  // namespace safety_control_cloud
