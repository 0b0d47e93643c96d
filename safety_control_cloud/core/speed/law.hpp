// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "../path/outline.hpp"
#include "../path/twist.hpp"

namespace safety_control_cloud {

/// What decides how fast one may approach.
struct Law {
  double sensor_period = 0.05;        ///< [s] between two looks
  double latency = 0.05;              ///< [s] from a look, or a wish, until the base has the command
  double base_reaction = 0.1;         ///< [s] until the base begins to obey it
  double linear_deceleration = 0.36;  ///< [m/s2] of the base (Kobuki's driver names it, though its limiter is off by
                                      ///< default and would use 0.6: a conservative assumption)
  double angular_deceleration = 3.5;  ///< [rad/s2] of the base (Kobuki, with the same reservation)
  double obstacle_speed = 0.0;        ///< [m/s] with which every obstacle may approach
  double escape_speed = 0.1;          ///< [m/s] of the fastest point of the footprint on the way out of the margin
  double noise = 0.01;                ///< [m] of the sensor
  std::size_t min_points = 1;         ///< so many returns make an obstacle
};

/// Everything that makes this no law to drive by, a sentence each; empty if it is one.
std::vector<std::string> problems_in(const Law& law);

/// Of the data decided on [s].
struct Age {
  double now = 0.0;
  double at_next_look = 0.0;  ///< that they will have come to before there are others
};

/// How a base answers to a change of factor along the path of a twist, all in [s].
struct Response {
  double delay;     ///< from a command to its effect: latency + base_reaction
  double reaction;  ///< in which the robot drives on, whatever appears: max(age, sensor_period) + delay
  double braking;   ///< from factor 1 to 0, both axes in proportion:
                    ///< max(hypot(vx, vy) / linear_deceleration, |w| / angular_deceleration)
};
Response response_to(const Law& law, const Age& age, const Twist2& twist);

/// [m] by which an obstacle may have come nearer since it was seen until the robot stands: it goes on at `factor` of
/// the twist until the next look, or is told now to brake from the `share` that it drives. Of the share no more, or who
/// was given all that there was would have to brake at the next look.
double approach(const Law& law, const Age& age, const Response& response, double factor, double share);

/// How much of a twist's path is used up by driving it at a factor s for a time T and stopping then, in [s] of the
/// twist at factor 1: s T + s^2 t_b / 2. The way in which a body stops from uniform deceleration, here along an arc; to
/// add a reaction is the idea of ISO 13855.
inline double stopping_time(double factor, double time, double braking) {
  return factor * time + 0.5 * factor * factor * braking;
}

/// The greatest factor s in [0, 1] with stopping_time(s, reaction, braking) <= time; 0 unless time > 0.
///
/// A robot that drives the path already, at a `share` k of the twist that is greater than this, goes on with k for the
/// delay, slows to s, keeps s until the reaction is over and stops; or it brakes all of that time. The factor is then
/// the greatest s <= k for which the former ends in time, k delay + s (reaction - delay) + ((k - s)^2 + s^2) t_b / 2
/// <= time; and 0 if not even the latter does, stopping_time(k, delay, braking).
double greatest_factor(double time, const Response& response, double share = 0.0);

/// [s] from which on, to within rounding, greatest_factor() is no less than `factor`, in [0, 1].
double least_time(double factor, const Response& response, double share);

}  // namespace safety_control_cloud
