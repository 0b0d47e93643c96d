// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "plane.hpp"

namespace safety_control_cloud {

constexpr double farthest_corner = 100.0;  ///< [m]: no robot reaches so far; millimetres would
constexpr double most_margin = 100.0;      ///< [m]
constexpr std::size_t most_corners = 100;  ///< every point is asked against each of them

/// What the robot covers of the floor, and how much more must stay clear around it.
struct Footprint {
  std::vector<Point2> polygon;  ///< corners in either order, convex or not; empty: a circle around base_frame's origin
  double radius = 0.0;          ///< [m] of the circle; 0 with a polygon
  double margin = 0.0;          ///< [m] kept clear around all of it
};

/// Everything that makes this no footprint, a sentence each; empty if it is one.
std::vector<std::string> problems_in(const Footprint& footprint);

}  // namespace safety_control_cloud
