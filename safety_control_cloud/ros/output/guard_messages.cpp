// SPDX-License-Identifier: BSD-3-Clause
#include "guard_messages.hpp"

#include <ros/time.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "messages.hpp"

namespace safety_control_cloud {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double free_ahead = std::numeric_limits<double>::infinity();

Zone zone_of(const Guarded& answer) {
  if (answer.factor >= 1.0 && answer.override_left == 0.0) return Zone::Safe;
  return answer.factor > 0.0 ? Zone::Warning : Zone::Danger;
}

geometry_msgs::Point point_of(const std::optional<Point2>& point) {
  geometry_msgs::Point message;
  message.x = point ? point->x : unknown;
  message.y = point ? point->y : unknown;
  message.z = point ? 0.0 : unknown;
  return message;
}

/// Steady moments mean nothing to others.
ros::Time ros_time_of(double steady) {
  const double ago = ros::SteadyTime::now().toSec() - steady, now = ros::Time::now().toSec();
  return ros::Time(std::max(0.0, now - ago));
}

}  // namespace

Command to_command(const geometry_msgs::Twist& twist) {
  return {{twist.linear.x, twist.linear.y, twist.linear.z}, {twist.angular.x, twist.angular.y, twist.angular.z}};
}

geometry_msgs::Twist to_twist(const Command& command) {
  geometry_msgs::Twist twist;
  twist.linear.x = command.linear[0], twist.linear.y = command.linear[1], twist.linear.z = command.linear[2];
  twist.angular.x = command.angular[0], twist.angular.y = command.angular[1], twist.angular.z = command.angular[2];
  return twist;
}

bool same_bits(const geometry_msgs::Twist& a, const geometry_msgs::Twist& b) {
  const Command one = to_command(a), other = to_command(b);
  return std::memcmp(&one, &other, sizeof one) == 0;
}

Decision to_decision(const Guarded& answer) {
  Decision decision;
  decision.zone = zone_of(answer);
  decision.speed = answer.given.linear[0];
  decision.cause = answer.cause;
  decision.reason = answer.reason;
  decision.hint = answer.hint;
  if (answer.point) decision.nearest = Obstacle{{NAN, NAN, static_cast<float>(length_of(*answer.point))}};
  if (answer.stuck) decision.stuck_since = answer.stuck_since;
  decision.sight = answer.sight;
  return decision;
}

SafetyState to_state(const Guarded& answer, const Settings& settings, const std_msgs::Header& cloud) {
  SafetyState state = to_state(to_decision(answer), settings, cloud);
  state.nearest_frame = settings.base_frame;
  state.nearest_point = point_of(answer.point);
  const bool is_free = answer.factor >= 1.0 && answer.in_view;
  state.nearest = answer.point ? length_of(*answer.point) : is_free ? free_ahead : unknown;
  state.wanted = to_twist(answer.wanted);
  state.given = to_twist(answer.given);
  state.factor = answer.factor;
  state.time_to_contact = answer.time_to_contact;
  state.sensor = answer.sensor;
  state.doubts = answer.doubts;
  state.stuck = answer.stuck;
  if (answer.stuck) state.stuck_since = ros_time_of(answer.stuck_since);
  state.open = answer.open;
  state.override_left = answer.override_left;
  return state;
}

Blocked to_blocked(const Guarded& answer, const Settings& settings) {
  Blocked blocked;
  blocked.header.frame_id = settings.base_frame;
  blocked.blocked = answer.stuck;
  blocked.wanted = to_twist(answer.wanted);
  blocked.cause = static_cast<std::uint8_t>(answer.cause);
  blocked.cause_text = name_of(answer.cause);
  blocked.reason = answer.reason;
  blocked.point = point_of(answer.point);
  blocked.open = answer.open;
  return blocked;
}

}  // namespace safety_control_cloud
