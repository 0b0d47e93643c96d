// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "thing.hpp"

namespace safety_control_cloud {

/// What was seen to hang still does, though something hides what is below it by now, or is seen there right behind it:
/// it may touch what stands. So it is told of each spot of `seen` whether the nearest one that is remembered hung, of
/// those that may have moved there since. `remembered`: what the cloud before showed, and what is lost.
void keep_hanging(std::vector<Thing>& seen, const std::vector<const std::vector<Spot>*>& remembered);

/// A thing of which only an edge is seen, above what hides its foot, stands if it is one of what stood there: if of all
/// its spots the nearest that is remembered stood, of those that may have moved there since.
void keep_standing(std::vector<Thing>& seen, const std::vector<const std::vector<Spot>*>& remembered);

}  // namespace safety_control_cloud
