// SPDX-License-Identifier: BSD-3-Clause
#include "ray_samples.hpp"

#include <cmath>

#include "../input/point_reader.hpp"
#include "../input/probes.hpp"

namespace safety_control_cloud {
RaySamples::RaySamples(const View& view) {
  const std::size_t width = width_of(view), height = height_of(view);
  for (auto& rays : in_row) rays.reserve(columns);
  for (auto& rays : in_column) rays.reserve(rows);
  with_reader(view, [&](auto reader) {
    for (std::size_t i = 0; i < rows * columns; ++i) {
      const std::size_t row = middle_of_part(i / columns, rows, height),
                        column = middle_of_part(i % columns, columns, width);
      const auto take = [&](float x, float y, float z) {
        if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return;
        if (!(z > 0.0f)) {
          behind += z < 0.0f || x != 0.0f || y != 0.0f;
          return;
        }
        const Ray ray{static_cast<double>(column), static_cast<double>(row), double{x} / z, double{y} / z};
        ++ahead;
        in_row[i / columns].push_back(ray);
        in_column[i % columns].push_back(ray);
      };
      reader(row, column, take);
    }
  });
}

}  // namespace safety_control_cloud
