// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evidence.hpp"
#include "gaze.hpp"

namespace safety_control_cloud {

constexpr double least_off = 0.0175;  ///< [rad] 1 degree: no direction is known better

/// A spot that was seen when the camera looked another way, as its present picture would show it.
struct TurnedSpot {
  struct Place {
    std::size_t row, column;
  };

  Spot spot;
  /// In the picture, the spot's own with them: where else the thing may be, by as much as its direction is not known,
  /// and by as much as it may have come nearer, ahead of the robot, since.
  std::vector<Place> places;
  bool is_whole = false;  ///< the thing lies in the picture wherever its direction may be
};

/// None if it lies beside the picture, or nobody knows which way the pixels look.
/// Its direction is known to the angle by which the camera turned from one picture to the next as the spot was seen,
/// but to no less than 1 degree.
/// `turning` [rad]: by so much the camera has turned from the picture before to this one.
std::optional<TurnedSpot> turned_spot(const Spot& spot, const Gaze& gaze, const Pixels& picture, float turning = 0.0f);

/// [rad] by which a spot lies above the picture or below it, be it beside that too or not; none if nobody knows.
std::optional<double> above_or_below(const Spot& spot, const Gaze& gaze, const Pixels& picture);

/// What all of its places say; nothing if they contradict each other, or one of them is a hole.
Evidence evidence_of(const TurnedSpot& turned, const Pixels& picture);

/// Whether all of them show it.
bool is_there(const TurnedSpot& turned, const Pixels& picture);

/// Whether there is a hole in any of its places.
bool leaves_a_hole(const TurnedSpot& turned, const Pixels& picture);

}  // namespace safety_control_cloud
