// SPDX-License-Identifier: BSD-3-Clause
// What a point means, one at a time. kernel/found-inl.hpp says the same of a vector of points; PCL's filters, in
// passthrough.cpp, are what both are held against.
#pragma once

#include <cmath>
#include <limits>

#include "outlook.hpp"

namespace safety_control_cloud {

/// Whether a point of the cloud, in the sensor's frame, is a return.
inline bool is_return(float x, float y, float z, const Corridor& corridor) {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && z > corridor.range_min;
}

/// -Inf in z says "something is too close to measure" (REP 117). It counts unless its x or y lies finitely outside;
/// placed in another frame it cannot be told to lie outside.
inline bool is_too_close(float x, float y, float z, const Outlook& outlook) {
  if (z != -std::numeric_limits<float>::infinity()) return false;
  if (outlook.placement) return true;
  const Corridor& corridor = outlook.corridor;
  const bool left_or_right = std::isfinite(x) && !corridor.spans(x);
  const bool above_or_below = std::isfinite(y) && (y < corridor.y_min || y > corridor.y_max);
  return !left_or_right && !above_or_below;
}

/// Of a return in the corridor's axes. Behind their origin there is no corridor, and a far point may overflow on its
/// way there.
inline bool is_inside(const Point& placed, const Corridor& corridor) {
  return corridor.holds(placed) && placed.z > 0.0f && std::isfinite(placed.z);
}

}  // namespace safety_control_cloud
