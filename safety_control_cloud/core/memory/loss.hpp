// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "../doubt/cause.hpp"
#include "../look/sight.hpp"

namespace safety_control_cloud {

/// So far a thing comes nearer between two clouds [m]: 2 m/s.
constexpr double step_nearer = 0.1;

/// Of a picture's width, from 0 at its left to 1.
struct Span {
  double from, to;
};

/// Where something was seen that is lost, in the frame of the cloud that showed it [m].
struct LostSpot {
  Point point;
  std::uint32_t picture;  ///< which one that was: NearLoss::picture()
};

/// Something near that is not among the returns in the corridor.
struct Loss {
  Cause cause = Cause::NearLoss;     ///< or LowObstacle
  std::optional<Obstacle> obstacle;  ///< as it was last seen; none if only the floor before it was ever seen
  bool whole = false;                ///< it has gone where the camera cannot see; not a few pixels at its edge
  std::string reason;
  std::optional<double> since = {};  ///< [s] steady, if it is out of sight
  std::string hint = {};             ///< what would free the robot, if it is

  // All that is lost, for who knows better where it is; nothing if that is not all.
  std::vector<Span> covered = {};    ///< where the near floor is hidden
  std::vector<LostSpot> spots = {};  ///< of things, where they were seen last
};

/// What nobody sees any more has a distance [m], but no place.
inline Obstacle remembered_at(double distance) {
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  return {Point(unknown, unknown, static_cast<float>(distance))};
}

}  // namespace safety_control_cloud
