// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "view.hpp"

namespace safety_control_cloud {

/// Every point of the view as float32, in its order and with its width and height; nothing is left out.
Cloud to_cloud(const View& view);

}  // namespace safety_control_cloud
