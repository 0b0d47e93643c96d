// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "near_search.hpp"
#include "thing.hpp"

namespace safety_control_cloud {

/// The near things in the corridor: pixels that touch and whose ranges go on without a jump. Looks at every n-th pixel
/// of at most so many rows that the time does not depend on the scene; a row that shows something nearer than those
/// pixels is looked at whole, so that nothing thin is lost.
std::vector<Thing> near_things(const NearSearch& search);

}  // namespace safety_control_cloud
