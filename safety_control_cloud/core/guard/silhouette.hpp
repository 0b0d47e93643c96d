// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../path/outline.hpp"

namespace safety_control_cloud {

/// How far a footprint reaches in a frame that is turned by some angle [rad] against its own [m].
struct Silhouette {
  double front, left, right;
};
Silhouette silhouette_of(const Footprint& footprint, double angle);

}  // namespace safety_control_cloud
