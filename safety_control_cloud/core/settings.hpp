// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "look/corridor.hpp"
#include "memory/near_loss.hpp"
#include "speed/speed.hpp"
#include "speed/stopping.hpp"
#include "speed/zone.hpp"

namespace safety_control_cloud {

/// How the corridor is searched: both give the same Sight.
enum class Method : std::uint8_t {
  OnePass,  ///< look(): one pass over the bytes
  Pcl,      ///< passthrough(): the tutorial's PCL filters, the specification
};

const char* name_of(Method method);  ///< "one_pass" or "pcl"
std::optional<Method> method_named(const std::string& name);

/// What the camera sends: from the same picture, both give the same Sight.
enum class Input : std::uint8_t {
  Cloud,  ///< points
  Depth,  ///< depth images
};

const char* name_of(Input input);  ///< "cloud" or "depth"
std::optional<Input> input_named(const std::string& name);

/// The corridor in a target frame (x forward, y left, z up), as distances and heights from its origin.
struct FrameCorridor {
  double left = 0.30;    ///< [m] to the left of the frame's x axis
  double right = 0.30;   ///< [m] to the right of it
  double bottom = 0.05;  ///< [m] height above the frame's origin
  double top = 0.55;     ///< [m] height above the frame's origin
};

/// Every parameter with its default; the only place where a default stands.
struct Settings {
  Corridor corridor;
  std::string target_frame;  ///< the corridor lies in this frame; empty: in the camera's optical frame
  FrameCorridor frame_corridor;
  ZoneLimits limits;
  Speeds speeds;
  Hold release;
  double source_timeout = 0.5;   ///< [s] without a cloud until the camera counts as silent
  double stamp_tolerance = 1.0;  ///< [s] a stamp may be off from now; 0 = any
  double min_valid_ratio = 0.1;  ///< share of returns below which the sensor counts as blind
  NearLossLimits near_loss;
  std::size_t frozen_clouds = 0;  ///< so many successive clouds with the same content are a frozen camera; 0 = off
  Stopping stopping;
  double publish_rate = 10.0;  ///< [Hz] at which a command goes out even if no cloud comes in
  Method method = Method::OnePass;
  Input input = Input::Cloud;
};

/// Calls visit(name, value) for every parameter, with the name it has in ROS, in YAML and in Python.
/// `settings` may be const; `visit` must take float, double, std::size_t, std::string, Method and Input.
template <class SettingsOrConst, class Visit>
void for_each_parameter(SettingsOrConst& settings, Visit visit) {
  visit("x_min", settings.corridor.x_min);
  visit("x_max", settings.corridor.x_max);
  visit("y_min", settings.corridor.y_min);
  visit("y_max", settings.corridor.y_max);
  visit("target_frame", settings.target_frame);
  visit("left", settings.frame_corridor.left);
  visit("right", settings.frame_corridor.right);
  visit("bottom", settings.frame_corridor.bottom);
  visit("top", settings.frame_corridor.top);
  visit("range_min", settings.corridor.range_min);
  visit("min_points", settings.corridor.min_points);
  visit("warning_distance", settings.limits.warning);
  visit("danger_distance", settings.limits.danger);
  visit("safe_speed", settings.speeds.safe);
  visit("warning_speed", settings.speeds.warning);
  visit("release_clouds", settings.release.clouds);
  visit("release_time", settings.release.time);
  visit("source_timeout", settings.source_timeout);
  visit("stamp_tolerance", settings.stamp_tolerance);
  visit("min_valid_ratio", settings.min_valid_ratio);
  visit("near_loss_distance", settings.near_loss.distance);
  visit("near_loss_timeout", settings.near_loss.timeout);
  visit("frozen_clouds", settings.frozen_clouds);
  visit("sensor_period", settings.stopping.sensor_period);
  visit("base_timeout", settings.stopping.base_timeout);
  visit("base_deceleration", settings.stopping.base_deceleration);
  visit("publish_rate", settings.publish_rate);
  visit("method", settings.method);
  visit("input", settings.input);
}

/// The corridor to look down, in the axes x right, y down, z forward of whichever frame it lies in.
Corridor corridor_of(const Settings& settings);

/// Everything that makes these settings unfit to drive with, a sentence each; empty if they are fit.
std::vector<std::string> problems_in(const Settings& settings);

/// What is fit but unwise: a danger_distance in which the robot could not stop.
std::vector<std::string> doubts_about(const Settings& settings);

}  // namespace safety_control_cloud
