// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "text/problems.hpp"

namespace safety_control_cloud {

/// Beyond its bounds no number is meant, and some disable what they set: a camera that may be silent for an hour, an
/// obstacle of two thousand million points. The rooms see to the other side: see their check().
void check_bound(const std::string& name, double value, Problems& problems);

}  // namespace safety_control_cloud
