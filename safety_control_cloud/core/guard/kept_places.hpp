// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pose.hpp"

namespace safety_control_cloud {

/// One of the places that are kept of what has left the picture.
struct KeptPlace {
  Point2 place;            ///< [m] in base_frame
  double height, off;      ///< [m] above it; by which it may be displaced
  std::size_t sensor = 0;  ///< that showed it last
};

/// What of them is written down, to outlive the process.
struct KeptPlaces {
  double stamp = 0.0;  ///< [s, ROS time] of the pose
  /// In the frame of odometry; none: that was not to be believed, or has jumped since, and what was near may be
  /// anywhere.
  std::optional<Pose2> robot = Pose2{};
  std::vector<KeptPlace> all;
  std::vector<std::string> sensors = {};  ///< the names of those that showed them
};

/// A line of text of at most 50 kilobytes: of places that lie close to each other and were shown by one sensor one,
/// which may be displaced by as much more, and the nearest of too many. Empty if there is none, and the pose is known.
std::string to_text(const KeptPlaces& kept);

/// What was written down; none if the text is not whole, or of another version.
std::optional<KeptPlaces> kept_places_in(const std::string& text);

/// Whether those of this stamp are older than `time` [s], at `now` [s, ROS time]; nobody knows as long as that is zero.
bool are_over(double stamp, double now, double time);

}  // namespace safety_control_cloud
