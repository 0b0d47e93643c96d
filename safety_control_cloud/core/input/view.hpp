// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <variant>

#include "cloud.hpp"
#include "depth.hpp"

namespace safety_control_cloud {

/// The points that a camera sent, in whichever form.
using View = std::variant<CloudView, DepthView>;

inline std::size_t width_of(const View& view) {
  return std::visit([](const auto& points) { return points.width; }, view);
}
inline std::size_t height_of(const View& view) {
  return std::visit([](const auto& points) { return points.height; }, view);
}
inline std::size_t size_of(const View& view) { return width_of(view) * height_of(view); }

/// [byte] from one point to the next in a row.
inline std::size_t step_of(const CloudView& cloud) { return cloud.point_step; }
inline std::size_t step_of(const DepthView& depth) { return depth.pixel_step(); }

}  // namespace safety_control_cloud
