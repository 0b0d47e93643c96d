// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "cloud.hpp"

namespace safety_control_cloud {

/// The space the robot is about to drive through, in the optical frame (x right, y down, z forward), limits inclusive.
/// float32 like pcl::PassThrough's limits, so that a point on a limit falls on the same side in both.
struct Corridor {
  float x_min = -0.30f;        ///< [m] to the left
  float x_max = 0.30f;         ///< [m] to the right
  float y_min = -0.25f;        ///< [m] up
  float y_max = 0.20f;         ///< [m] down
  float range_min = 0.0f;      ///< [m] a return lies farther than this along z; (0, 0, 0) is no return
  std::size_t min_points = 1;  ///< this many points make an obstacle
};

/// A point that the robot would run into.
struct Obstacle {
  Point point;  ///< optical frame [m]; the origin if the sensor reported "too close" (-Inf, REP 117)

  double distance() const { return point.z; }  ///< [m] along z from the sensor
};

/// What one cloud shows. "Nothing in the corridor" is an empty `nearest`; "could not look" is no Sight at all.
struct Sight {
  std::optional<Obstacle> nearest;  ///< the min_points-th smallest z; of equals, the first in the cloud
  std::size_t inside = 0;           ///< returns in the corridor
  std::size_t too_close = 0;        ///< points at -Inf that cannot be placed outside the corridor
  std::size_t returns = 0;          ///< points with finite x, y, z and z > range_min
  std::size_t total = 0;            ///< points of the cloud
  Cloud::Ptr crop;                  ///< the returns in the corridor, in the cloud's order, if asked for
};

enum class Crop { Skip, Keep };

/// Looks down the corridor in one pass over the cloud's bytes.
Sight look(const CloudView& cloud, const Corridor& corridor, Crop crop);

/// -Inf in z says "something is too close to measure" (REP 117). It counts unless its x or y lies finitely outside.
bool is_too_close(float x, float y, float z, const Corridor& corridor);

/// The obstacle of a crop: the min_points-th point by z, where the points that are too close come first, at distance 0.
std::optional<Obstacle> nearest_of(std::size_t too_close, const Cloud& inside, const Corridor& corridor);

}  // namespace safety_control_cloud
