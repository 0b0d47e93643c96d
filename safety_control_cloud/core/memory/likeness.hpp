// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "thing.hpp"

namespace safety_control_cloud {

/// So far a thing moves from one cloud to the next [m]: 3 m/s.
constexpr float farthest_step = 0.15f;

/// [m2]
inline float squared_distance(const Point& a, const Point& b) {
  return (a.getVector3fMap() - b.getVector3fMap()).squaredNorm();
}

/// Of what they stand for, in the cloud's frame [m].
Eigen::Vector3f middle_of(const std::vector<Spot>& spots);

/// What a thing that was seen has in common with one that is.
struct Likeness {
  double share = 0.0;      ///< of what was seen: how much lies close to what is seen
  double closeness = 0.0;  ///< how close: 1 where it has not moved
};

Likeness likeness_of(const std::vector<Spot>& before, const Thing& now);

/// Of a thing that is as large as it was, tells of what it showed nearer than `near` [m] whether that came along with
/// the rest of it, or went alone: nothing is shown of it so near any more.
void note_what_went_alone(std::vector<Spot>& before, const Thing& now, float near);

}  // namespace safety_control_cloud
