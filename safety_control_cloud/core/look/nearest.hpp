// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sight.hpp"

namespace safety_control_cloud {

/// What is too close to measure, at distance 0.
Obstacle too_close_to_measure();

/// How many of the points inside, by z, come before the one that makes an obstacle, as the points that are too close
/// come first of all; none if these suffice.
std::optional<std::size_t> rank_of(std::size_t too_close, std::size_t min_points);

/// The value that has `rank` others before it when all are in order; infinity if there are not so many.
float ranked(std::vector<float> values, std::size_t rank);

/// The z that has `rank` others before it among the points'; infinity if there are not so many.
float ranked_z(const Cloud& cloud, std::size_t rank);

/// The first point at distance z [m], of which there is one.
Obstacle first_at(const Cloud& cloud, float z);

/// The obstacle of the points inside, in the corridor's axes: the min_points-th by z, where the points that are too
/// close come first, at distance 0.
std::optional<Obstacle> nearest_of(std::size_t too_close, const Cloud& inside, std::size_t min_points);

}  // namespace safety_control_cloud
