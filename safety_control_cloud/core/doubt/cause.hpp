// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace safety_control_cloud {

/// Why a decision is what it is. A closed list: it stands in SafetyState.msg and in the README too.
enum class Cause : std::uint8_t {
  Seen = 0,            ///< the cloud could be read and the sensor sees
  NoCloud = 1,         ///< nothing received yet
  Silent = 2,          ///< no cloud for source_timeout, or a switch that nobody publishes any more
  Unreadable = 3,      ///< the cloud's layout contradicts itself
  Blind = 4,           ///< too few returns to tell free space from no sight
  Stale = 5,           ///< the stamp is older than stamp_tolerance, or later by source_timeout than this sensor's usually come
  Future = 6,          ///< the stamp is further ahead than stamp_tolerance
  ClockJump = 7,       ///< ROS time went backwards
  NearLoss = 8,        ///< something near stopped returning and nothing has been seen behind it
  Frozen = 9,          ///< frozen_clouds clouds with new stamps and the same content
  NoTransform = 10,    ///< the camera's place in target_frame, or as a guard in base_frame, is not known
  TwoSources = 11,     ///< clouds of two publishers arrive in turn
  LowObstacle = 12,    ///< something lower than the corridor stands on the near floor
  TwoCommanders = 13,  ///< somebody else commands the robot on the same topic
  WrongView = 14,      ///< the cloud is no optical one, or its camera does not look down the corridor
  NoTime = 15,         ///< ROS time is 0: it is simulated, and nobody publishes /clock
  NoCommand = 16,      ///< guard: nobody commands the robot, or not for command_timeout
  BadCommand = 17,     ///< guard: a command holds NaN, an infinity, what no robot can drive, or a stamp that is 0, old or ahead
  NoOdometry = 18,     ///< guard: odometry jumped, stopped or contradicts the commands, and what is out of sight cannot be placed
  Bumper = 19,         ///< guard: the robot touches something, or did until just now
  Cliff = 20,          ///< guard: the floor ends under the robot's edge, or did until just now
};

const char* name_of(Cause cause);  ///< "SEEN", "NO_CLOUD", ...

}  // namespace safety_control_cloud
