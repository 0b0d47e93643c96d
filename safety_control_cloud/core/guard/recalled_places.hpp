// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "../path/twist.hpp"
#include "kept_places.hpp"
#include "sensors.hpp"

namespace safety_control_cloud {

/// The sensors' names as a text of kept places has them: what a camera showed is no scan's, whatever that is named by
/// then.
std::vector<std::string> written_names(const Sensors& sensors);

/// What another process kept, each place as shown by the sensor that has its sensor's name by now; or else by a camera:
/// a scan would forget what lies beside its plane.
std::vector<KeptPlace> shown_by(const Sensors& sensors, const KeptPlaces& kept);

/// Where the robot was when they were kept, in the turn of its pose by now, at a stamp [s, ROS]; none, if it cannot
/// have come from there since by its fastest motion: odometry began anew.
std::optional<Pose2> seen_from(const KeptPlaces& kept, const Pose2& robot, double stamp, const Twist2& fastest);

}  // namespace safety_control_cloud
