// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "obstacles.hpp"
#include "sweep.hpp"

namespace safety_control_cloud {

/// What a motion runs into, and when.
struct Contact {
  double time = std::numeric_limits<double>::infinity();  ///< [s] of the twist
  std::optional<std::size_t> point;                       ///< which of the obstacles; none: nothing is run into
};

/// When so many returns have been touched, given the time until each is; `min_points` 0 counts as 1.
Contact contact(const Obstacles& obstacles, const std::vector<double>& times, std::size_t min_points);

/// The same, given who knows the time of a point. Where one return is enough, no more are looked at once one is touched
/// before `hopeless` [s].
template <class TimeOf>
Contact contact(const Obstacles& obstacles, std::size_t min_points, double hopeless, TimeOf time_of) {
  Contact first;
  std::vector<double> times;
  for (std::size_t i = 0; i < obstacles.points.size(); ++i) {
    const double time = time_of(obstacles.points[i]);
    if (min_points > 1) times.push_back(time);
    if (time < first.time) first = {time, i};
    if (min_points <= 1 && first.time < hopeless) break;
  }
  return min_points > 1 ? contact(obstacles, times, min_points) : first;
}

}  // namespace safety_control_cloud
