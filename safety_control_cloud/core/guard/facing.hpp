// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "../look/placement.hpp"
#include "../path/outline.hpp"

namespace safety_control_cloud {

/// [rad] from base_frame's x axis, anticlockwise: which way a camera that is placed there looks; none if it looks
/// straight up or down.
std::optional<double> heading_of(const Placement& placement);

/// The same camera in a frame that is turned by this angle [rad] against base_frame.
Placement in_turned_frame(const Placement& placement, double angle);

/// How far a footprint reaches in such a frame [m].
struct Silhouette {
  double front, left, right;
};
Silhouette silhouette_of(const Footprint& footprint, double angle);

}  // namespace safety_control_cloud
