// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "../path/footprint.hpp"
#include "../path/obstacles.hpp"
#include "../text/problems.hpp"
#include "lists.hpp"
#include "sensors.hpp"
#include "switches.hpp"

namespace safety_control_cloud {

/// Who wants the robot to move.
enum class Mode : std::uint8_t {
  Drive,  ///< the node itself, straight ahead, as the tutorial has it
  Guard,  ///< somebody else, from whose commands what is unsafe is taken
};

const char* name_of(Mode mode);  ///< "drive" or "guard"
std::optional<Mode> mode_named(const std::string& name);

/// How somebody's commands come.
enum class CommandType : std::uint8_t {
  Twist,
  TwistStamped,  ///< nothing old is obeyed
};

const char* name_of(CommandType type);  ///< "twist" or "twist_stamped"
std::optional<CommandType> command_type_named(const std::string& name);

/// What the guard has to know of the robot, beside what the drive mode knows.
struct GuardSettings {
  Mode mode = Mode::Drive;
  std::string base_frame = "base_footprint";  ///< x forward, y left, z up; what turns when the robot turns in place
  std::string odom_frame;                     ///< in which TF says where base_frame is; empty: nav_msgs/Odometry does
  Lists footprint;                            ///< [m] corners in base_frame; none: a circle
  double radius = 0.178;                      ///< [m] of the circle, a Kobuki's; with a footprint it is not asked
  double margin = 0.05;                       ///< [m] kept clear around the footprint
  Lists self_boxes;  ///< [m] x_min, x_max, y_min, y_max, z_min, z_max: parts of the robot a sensor may see
  CommandType command_type = CommandType::Twist;
  double command_max_age = 0.3;       ///< [s] since its stamp at which a TwistStamped may still come
  double command_timeout = 0.5;       ///< [s] an older command is none
  double min_speed = 0.01;            ///< [m/s] of the fastest point; a base does not obey what is left below this
  double max_speed = 0.7;             ///< [m/s]
  double max_turn = 3.14;             ///< [rad/s]
  bool zone_caps = false;             ///< whether the drive mode's zones cap what leads to where a sensor looks
  double escape_speed = 0.1;          ///< [m/s] of the fastest point on the way out of the margin
  double unseen_speed = 0.1;          ///< [m/s] of its fastest point, if all of a motion leads out of sight; 0 = never
  double override_max = 0.0;          ///< [s] for which ~override may hold; 0 = it is refused
  double override_speed = 0.1;        ///< [m/s] of the fastest point meanwhile, at most
  double latency = 0.05;              ///< [s] from a look, or a wish, until the base has the command
  double base_reaction = 0.1;         ///< [s] until the base begins to obey it
  double angular_deceleration = 3.5;  ///< [rad/s2] of the base when it brakes (Kobuki's driver: an assumption)
  double obstacle_speed = 0.0;        ///< [m/s] with which every obstacle may approach
  double noise = 0.01;                ///< [m] of the sensor
  double memory_distance = 1.5;       ///< [m] from base_frame: what came so near is kept out of sight; 0 = off
  double memory_time = 30.0;          ///< [s] for so long
  double odometry_drift = 0.02;       ///< [m/m], [rad/rad] by which odometry may be off
  Sensors sensors;                    ///< none: the one of `input`
  Switches switches;                  ///< bumpers and cliff sensors
  double switch_release_time = 0.5;   ///< [s] for which one must have been released before its side is open
};

/// Calls visit(name, value) for every parameter; `guard` may be const.
template <class GuardSettingsOrConst, class Visit>
void for_each_guard_parameter(GuardSettingsOrConst& guard, Visit& visit) {
  visit("mode", guard.mode);
  visit("base_frame", guard.base_frame);
  visit("odom_frame", guard.odom_frame);
  visit("footprint", guard.footprint);
  visit("radius", guard.radius);
  visit("margin", guard.margin);
  visit("self_boxes", guard.self_boxes);
  visit("command_type", guard.command_type);
  visit("command_max_age", guard.command_max_age);
  visit("command_timeout", guard.command_timeout);
  visit("min_speed", guard.min_speed);
  visit("max_speed", guard.max_speed);
  visit("max_turn", guard.max_turn);
  visit("zone_caps", guard.zone_caps);
  visit("escape_speed", guard.escape_speed);
  visit("unseen_speed", guard.unseen_speed);
  visit("override_max", guard.override_max);
  visit("override_speed", guard.override_speed);
  visit("latency", guard.latency);
  visit("base_reaction", guard.base_reaction);
  visit("angular_deceleration", guard.angular_deceleration);
  visit("obstacle_speed", guard.obstacle_speed);
  visit("noise", guard.noise);
  visit("memory_distance", guard.memory_distance);
  visit("memory_time", guard.memory_time);
  visit("odometry_drift", guard.odometry_drift);
  visit("sensors", guard.sensors);
  visit("switches", guard.switches);
  visit("switch_release_time", guard.switch_release_time);
}

void check(const GuardSettings& guard, Problems& problems);

/// Of settings that are fit; what cannot be read is no footprint and no boxes.
Footprint footprint_of(const GuardSettings& guard);
std::vector<OwnBox> own_boxes_of(const GuardSettings& guard);

}  // namespace safety_control_cloud
