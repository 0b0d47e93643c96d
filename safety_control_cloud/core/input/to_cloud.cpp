// SPDX-License-Identifier: BSD-3-Clause
#include "to_cloud.hpp"

#include "point_reader.hpp"

namespace safety_control_cloud {

Cloud to_cloud(const View& view) {
  Cloud cloud;
  cloud.reserve(size_of(view));
  for_each_point(view, [&](float x, float y, float z) { cloud.points.emplace_back(x, y, z); });
  cloud.width = static_cast<std::uint32_t>(width_of(view));
  cloud.height = static_cast<std::uint32_t>(height_of(view));
  cloud.is_dense = false;
  return cloud;
}

}  // namespace safety_control_cloud
