// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "../doubt/doubt.hpp"
#include "../speed/law.hpp"
#include "../speed/zone.hpp"
#include "horizon.hpp"
#include "pose.hpp"
#include "surroundings.hpp"

namespace safety_control_cloud {

/// A zone, and how fast the robot may go into it.
struct ZoneCap {
  Zone zone;
  double speed;               ///< [m/s]
  Point2 ahead = {1.0, 0.0};  ///< in base_frame, of length 1: where the corridor leads in which that is seen
};

/// What one sensor lets one know of the robot's surroundings at this moment.
struct Known {
  std::string sensor;                        ///< its name
  const std::vector<Ring>* rings = nullptr;  ///< as they were taken; none: nothing was ever seen
  Law law;                                   ///< by which that is judged
  Age age;                                   ///< of that
  std::vector<Pose2> ways;     ///< that the robot may have gone since then; the true one lies between them
  std::optional<Eye> eye;      ///< where it looks
  Horizon horizon;             ///< and how far it sees there
  std::optional<Doubt> doubt;  ///< why it is not to be believed: nothing is safe
  std::optional<Doubt> lost;   ///< why it is not to be believed where it looks: only away from there
  bool is_placed = false;      ///< what hides all from it is remembered as places: also to the side, and turning
  std::string hint;            ///< what would free it then, or of what stands where nobody sees it
  std::optional<ZoneCap> cap;  ///< on what leads to where it looks
  bool is_touched = false;     ///< by what was lost: then slowly, though another sensor looks there
  bool is_reckoned = false;    ///< nobody knows well where it is: see Guard::by_ring
  bool is_missed = false;  ///< it is of that, but below the picture, above it or too near: it counts for who is shown
  std::optional<Eye> seen_by;  ///< that, if it looks still
  bool is_at_large = false;    ///< it may have gone on since: it counts where none of these looks, which would see it
  std::vector<Eye> watched_by;
};

}  // namespace safety_control_cloud
