// SPDX-License-Identifier: BSD-3-Clause
#include "probes.hpp"

#include <cmath>
#include <limits>

#include "point_reader.hpp"

namespace safety_control_cloud {

Probes::Probes() { depths.fill(std::numeric_limits<float>::quiet_NaN()); }

Probes::Probes(const View& view) : Probes() {
  const std::size_t width = width_of(view), height = height_of(view);
  if (width < across || height < down) return;
  with_reader(view, [&](auto reader) {
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const auto take = [&](float x, float y, float z) {
        if (std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && z > 0.0f) depths[i] = z;
      };
      reader(middle_of_part(i / across, down, height), middle_of_part(i % across, across, width), take);
    }
  });
}

}  // namespace safety_control_cloud
