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

/// As contact() asks for it.
inline auto time_by(const Sweep& sweep) {
  return [&sweep](const Point2& point, double before) { return sweep.time_to_contact(point, before); };
}

/// The same, given who knows the time of a point, or that it is no less than what it is told besides. Where one return
/// is enough, no more are looked at once one is touched before `hopeless` [s]; `first` is what is known already, by the
/// same motion. Nobody asks whether a point counts that would not be the first.
template <class TimeOf>
Contact contact(const Obstacles& obstacles, std::size_t min_points, double hopeless, TimeOf time_of,
                Contact first = {}) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const auto& points = obstacles.points;
  const auto time_before = [&](std::size_t i, double before) {
    const double time = time_of(points[i], before);
    return time < before && obstacles.condition.holds_for(points, i) ? time : never;
  };
  if (min_points > 1) {
    std::vector<double> times(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) times[i] = time_before(i, never);
    return contact(obstacles, times, min_points);
  }
  for (std::size_t i = 0; i < points.size() && !(first.time < hopeless); ++i) {
    const double time = time_before(i, first.time);
    if (time < first.time) first = {time, i};
  }
  return first;
}

}  // namespace safety_control_cloud
