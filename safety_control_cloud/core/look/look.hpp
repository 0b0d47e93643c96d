// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "../input/runs.hpp"
#include "outlook.hpp"
#include "sight.hpp"

namespace safety_control_cloud {

/// Looks down the corridor in one pass over the view's bytes. Where rows are to be told apart, it says what is nearest
/// in each.
Sight look(const View& view, const Outlook& outlook, Crop crop = Crop::Skip, Rows rows = Rows::Joined);

/// Something else that is done with each run of a view, in their order.
using Alongside = std::function<void(const Run&)>;

/// look() with something alongside, while a run's bytes are still in the cache.
Sight look_alongside(const View& view, const Outlook& outlook, Crop crop, Rows rows, const Alongside& alongside);

}  // namespace safety_control_cloud
