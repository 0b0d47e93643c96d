// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "../../../safety_control_cloud/core/input/cloud.hpp"

namespace safety_control_cloud {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

struct Xyz {
  float x, y, z;
};

/// An unorganised view over points that live in the test.
inline CloudView view_of(const std::vector<Xyz>& points) {
  CloudView view;
  view.bytes = reinterpret_cast<const std::uint8_t*>(points.data());
  view.width = points.size();
  view.height = 1;
  view.point_step = sizeof(Xyz);
  view.row_step = points.size() * sizeof(Xyz);
  view.offset = {0, 4, 8};
  return view;
}

}  // namespace safety_control_cloud
