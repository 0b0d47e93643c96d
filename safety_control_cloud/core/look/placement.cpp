// SPDX-License-Identifier: BSD-3-Clause
#include "placement.hpp"

#include <cmath>

namespace safety_control_cloud {

std::array<float, 3> in_turned_axes(const std::array<float, 3>& axes, double angle) {
  const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  const auto [right, down, forward] = axes;
  return {c * right + s * forward, down, c * forward - s * right};
}

Placement in_turned_frame(const Placement& placement, double angle) {
  if (angle == 0.0) return placement;
  Placement turned = placement;
  auto& [x, y, z] = turned.rows;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto [right, down, forward] = in_turned_axes({x[i], y[i], z[i]}, angle);
    x[i] = right, y[i] = down, z[i] = forward;
  }
  return turned;
}

Placing placing_of(const Eigen::Matrix<double, 3, 4>& cloud_in_target) {
  if (!cloud_in_target.allFinite()) return NoTransform{"the transform is not finite"};
  Eigen::Matrix3d to_corridor;  // right = -left, down = -up, forward = forward
  to_corridor << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  const Eigen::Matrix<float, 3, 4> rows = (to_corridor * cloud_in_target).cast<float>();
  Placement placement;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      placement.rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = rows(row, column);
    }
  }
  return placement;
}

}  // namespace safety_control_cloud
