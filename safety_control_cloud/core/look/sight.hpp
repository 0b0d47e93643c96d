// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "../input/cloud.hpp"

namespace safety_control_cloud {

/// A point that the robot would run into.
struct Obstacle {
  Point point;  ///< in the corridor's axes [m]; the origin if the sensor reported "too close" (-Inf, REP 117)

  double distance() const { return point.z; }  ///< [m] forward
};

/// What one cloud shows. "Nothing in the corridor" is an empty `nearest`; "could not look" is no Sight at all.
struct Sight {
  std::optional<Obstacle> nearest;     ///< the min_points-th smallest z; of equals, the first in the cloud
  std::size_t inside = 0;              ///< returns in the corridor
  std::size_t too_close = 0;           ///< points at -Inf that cannot be placed outside the corridor
  std::size_t returns = 0;             ///< points with finite x, y, z and z > range_min
  std::size_t total = 0;               ///< points of the cloud
  std::vector<float> nearest_in_rows;  ///< [m] smallest z of each row, infinity if none; where rows were told apart
  Cloud::Ptr crop;                     ///< the returns in the corridor, in the cloud's order and frame, if asked for
};

enum class Crop { Skip, Keep };

}  // namespace safety_control_cloud
