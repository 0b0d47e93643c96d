// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

#include <algorithm>
#include <utility>

#include "../text/choice.hpp"

namespace safety_control_cloud {
namespace {

using Numbers = std::vector<std::vector<double>>;

constexpr double farthest_corner = 3.0;  ///< [m] from base_frame: the near points are kept to the millimetre

void check_footprint(const GuardSettings& guard, Problems& problems) {
  if (!lists_in(guard.footprint, 2)) {
    problems.require(false, "footprint must be a list of corners, [[x, y], ...]");
    return;
  }
  const Footprint footprint = footprint_of(guard);
  for (const std::string& problem : problems_in(footprint)) problems.require(false, "footprint: " + problem);
  const auto is_near = [](const Point2& corner) { return length_of(corner) <= farthest_corner; };
  problems.require(std::all_of(footprint.polygon.begin(), footprint.polygon.end(), is_near),
                   "footprint: no corner may be farther than 3 m");
}

void check_boxes(const GuardSettings& guard, Problems& problems) {
  const auto boxes = lists_in(guard.self_boxes, 6);
  problems.require(boxes.has_value(), "self_boxes must be a list, [[x_min, x_max, y_min, y_max, z_min, z_max], ...]");
  for (const auto& box : boxes.value_or(Numbers{})) {
    const bool is_box = box[0] < box[1] && box[2] < box[3] && box[4] < box[5];
    problems.require(is_box, "each of self_boxes must have min less than max, three times");
  }
}

}  // namespace

const char* name_of(Mode mode) { return mode == Mode::Guard ? "guard" : "drive"; }

std::optional<Mode> mode_named(const std::string& name) { return choice_named(name, {Mode::Drive, Mode::Guard}); }

const char* name_of(CommandType type) { return type == CommandType::TwistStamped ? "twist_stamped" : "twist"; }

std::optional<CommandType> command_type_named(const std::string& name) {
  return choice_named(name, {CommandType::Twist, CommandType::TwistStamped});
}

void check(const GuardSettings& guard, Problems& problems) {
  check_footprint(guard, problems);
  check_boxes(guard, problems);
  check(guard.sensors, problems);
  check(guard.switches, problems);
  problems.require(!guard.base_frame.empty(), "base_frame must not be empty");
  problems.require_frame("base_frame", guard.base_frame);
  problems.require_frame("odom_frame", guard.odom_frame);
  problems.require(guard.odom_frame.empty() || guard.odom_frame != guard.base_frame,
                   "odom_frame must not be base_frame");
  problems.require(guard.command_max_age > 0.0, "command_max_age must be positive");
  problems.require(guard.command_timeout > 0.0, "command_timeout must be positive");
  problems.require(guard.min_speed >= 0.0, "min_speed must not be negative");
  problems.require(guard.max_speed > 0.0, "max_speed must be positive");
  problems.require(guard.min_speed <= guard.max_speed, "min_speed must not be above max_speed: what is less becomes 0");
  problems.require(guard.max_turn > 0.0, "max_turn must be positive");
  problems.require(guard.escape_speed >= 0.0, "escape_speed must not be negative");
  problems.require(guard.unseen_speed >= 0.0, "unseen_speed must not be negative");
  problems.require(guard.override_max >= 0.0, "override_max must not be negative");
  problems.require(guard.override_speed > 0.0, "override_speed must be positive");
  for (const auto& [name, speed] :
       {std::pair("escape_speed", guard.escape_speed), {"unseen_speed", guard.unseen_speed}})
    problems.require(speed == 0.0 || speed >= guard.min_speed,
                     std::string(name) + " must be 0 or at least min_speed: what is less becomes 0");
  problems.require(guard.override_speed >= guard.min_speed,
                   "override_speed must be at least min_speed: what is less becomes 0");
  problems.require(guard.latency >= 0.0, "latency must not be negative");
  problems.require(guard.base_reaction >= 0.0, "base_reaction must not be negative");
  problems.require(guard.angular_deceleration > 0.0, "angular_deceleration must be positive");
  problems.require(guard.obstacle_speed >= 0.0, "obstacle_speed must not be negative");
  problems.require(guard.noise >= 0.0, "noise must not be negative");
  problems.require(guard.memory_distance >= 0.0, "memory_distance must not be negative");
  problems.require(guard.memory_time >= 0.0, "memory_time must not be negative");
  problems.require(guard.odometry_drift >= 0.0, "odometry_drift must not be negative");
  problems.require(guard.switch_release_time >= 0.0, "switch_release_time must not be negative");
}

Footprint footprint_of(const GuardSettings& guard) {
  Footprint footprint{{}, 0.0, guard.margin};
  for (const auto& corner : lists_in(guard.footprint, 2).value_or(Numbers{}))
    footprint.polygon.push_back({corner[0], corner[1]});
  if (footprint.polygon.empty()) footprint.radius = guard.radius;
  return footprint;
}

std::vector<OwnBox> own_boxes_of(const GuardSettings& guard) {
  std::vector<OwnBox> boxes;
  for (const auto& box : lists_in(guard.self_boxes, 6).value_or(Numbers{}))
    boxes.push_back({box[0], box[1], box[2], box[3], box[4], box[5]});
  return boxes;
}

}  // namespace safety_control_cloud
