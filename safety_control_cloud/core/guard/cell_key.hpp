// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

#include "../path/plane.hpp"

namespace safety_control_cloud {

/// Of a place and its height, the cell in which they are: so wide across and so high [m]. Far away, two share a key.
inline std::uint64_t key_of_cell(const Point2& place, double across, double height, double up) {
  const auto part = [](double value) { return static_cast<std::uint64_t>(std::llround(value)) & 0x1fffffU; };
  return part(place.x / across) << 42U | part(place.y / across) << 21U | part(height / up);
}

}  // namespace safety_control_cloud
