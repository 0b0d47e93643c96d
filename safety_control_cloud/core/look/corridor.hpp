// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "../memory/pixel_memory.hpp"
#include "placement.hpp"
#include "../input/view.hpp"

namespace safety_control_cloud {

/// The space the robot is about to drive through (x right, y down, z forward), limits inclusive.
/// float32 like pcl::PassThrough's limits, so that a point on a limit falls on the same side in both.
struct Corridor {
  float x_min = -0.30f;        ///< [m] to the left
  float x_max = 0.30f;         ///< [m] to the right
  float y_min = -0.25f;        ///< [m] up
  float y_max = 0.20f;         ///< [m] down
  float range_min = 0.0f;      ///< [m] a return lies farther than this along the sensor's z; (0, 0, 0) is no return
  std::size_t min_points = 1;  ///< this many points make an obstacle

  bool spans(float x) const { return x >= x_min && x <= x_max; }
  bool holds(const Point& point) const { return spans(point.x) && point.y >= y_min && point.y <= y_max; }
};

/// A point that the robot would run into.
struct Obstacle {
  Point point;  ///< in the corridor's axes [m]; the origin if the sensor reported "too close" (-Inf, REP 117)

  double distance() const { return point.z; }  ///< [m] forward
};

/// What one cloud shows. "Nothing in the corridor" is an empty `nearest`; "could not look" is no Sight at all.
struct Sight {
  std::optional<Obstacle> nearest;  ///< the min_points-th smallest z; of equals, the first in the cloud
  std::size_t inside = 0;           ///< returns in the corridor
  std::size_t too_close = 0;        ///< points at -Inf that cannot be placed outside the corridor
  std::size_t returns = 0;          ///< points with finite x, y, z and z > range_min
  std::size_t total = 0;            ///< points of the cloud
  std::size_t lost = 0;             ///< pixels without a return whose last one was near and in the corridor
  Cloud::Ptr crop;                  ///< the returns in the corridor, in the cloud's order and frame, if asked for
};

enum class Crop { Skip, Keep };

/// How to look, beside where: all of it in the same pass.
struct Gaze {
  Crop crop = Crop::Skip;
  const Placement* placement = nullptr;  ///< nullptr: the corridor lies in the cloud's own frame
  PixelMemory* memory = nullptr;         ///< brought up to date if given; must have the cloud's size
};

/// Looks down the corridor in one pass over the view's bytes.
Sight look(const View& view, const Corridor& corridor, const Gaze& gaze = {});

/// Whether a point of the cloud, in the sensor's frame, is a return.
inline bool is_return(float x, float y, float z, const Corridor& corridor) {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && z > corridor.range_min;
}

/// -Inf in z says "something is too close to measure" (REP 117). It counts unless its x or y lies finitely outside;
/// placed in another frame it cannot be told to lie outside.
bool is_too_close(float x, float y, float z, const Corridor& corridor, const Gaze& gaze);

/// A return in the corridor's axes. Behind their origin there is no corridor.
inline Point placed(float x, float y, float z, const Gaze& gaze) {
  return gaze.placement ? (*gaze.placement)(x, y, z) : Point(x, y, z);
}
inline bool is_inside(const Point& point, const Corridor& corridor) {
  return corridor.holds(point) && point.z > 0.0f && std::isfinite(point.z);  // a far point may overflow on its way here
}

/// Where the camera is, in the corridor's axes.
inline Point camera_in(const Gaze& gaze) {
  if (!gaze.placement) return Point(0.0f, 0.0f, 0.0f);
  const auto& [x, y, z] = gaze.placement->rows;
  return Point(x[3], y[3], z[3]);
}

/// What a pixel of the gaze's memory remembers of a return at this place.
std::uint16_t remembered(const Point& point, const Corridor& corridor, const Gaze& gaze);

/// The obstacle of the points inside, in the corridor's axes: the min_points-th by z, where the points that are too
/// close come first, at distance 0.
std::optional<Obstacle> nearest_of(std::size_t too_close, const Cloud& inside, const Corridor& corridor);

}  // namespace safety_control_cloud
