// SPDX-License-Identifier: BSD-3-Clause
#include "cloud.hpp"

#include "point_reader.hpp"

namespace safety_control_cloud {

Cloud to_cloud(const CloudView& view) {
  Cloud cloud;
  cloud.reserve(view.size());
  for_each_point(view, [&](float x, float y, float z) { cloud.points.emplace_back(x, y, z); });
  cloud.width = static_cast<std::uint32_t>(view.width);
  cloud.height = static_cast<std::uint32_t>(view.height);
  cloud.is_dense = false;
  return cloud;
}

}  // namespace safety_control_cloud
