// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../look/placement.hpp"
#include "../path/outline.hpp"

namespace safety_control_cloud {

/// A camera's place in a frame that is turned by this angle [rad] against its own.
Placement in_turned_frame(const Placement& placement, double angle);

/// How far a footprint reaches in such a frame [m].
struct Silhouette {
  double front, left, right;
};
Silhouette silhouette_of(const Footprint& footprint, double angle);

}  // namespace safety_control_cloud
