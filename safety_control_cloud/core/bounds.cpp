// SPDX-License-Identifier: BSD-3-Clause
#include "bounds.hpp"

#include "text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double corridor = 10.0;  ///< [m] to each side
constexpr double range = 20.0;     ///< [m] no depth camera measures farther
/// [m/s] What is faster needs more than the 5 m that most depth cameras see to stop in.
constexpr double speed = 1.5;

/// The most that a number may be, up or down.
struct Bound {
  const char* name;
  double most;
};

constexpr Bound bounds[] = {
    {"x_min", corridor},
    {"x_max", corridor},
    {"y_min", corridor},
    {"y_max", corridor},
    {"left", corridor},
    {"right", corridor},
    {"bottom", corridor},
    {"top", corridor},
    {"range_min", range},
    {"min_points", 1000},
    {"warning_distance", range},
    {"danger_distance", range},
    {"safe_speed", speed},
    {"warning_speed", speed},
    {"release_clouds", 1000},
    {"release_time", 60.0},
    {"source_timeout", 10.0},
    {"stamp_tolerance", 60.0},
    {"near_loss_timeout", 86400},
    {"min_returns", 1e6},
    {"frozen_clouds", 1000},
    {"sensor_period", 10.0},
    {"base_timeout", 10.0},
    {"base_deceleration", 20.0},
    {"hull", corridor},
    {"radius", 3.0},
    {"margin", 1.0},
    {"command_max_age", 10.0},
    {"command_timeout", 10.0},
    {"min_speed", speed},
    {"max_speed", speed},
    {"max_turn", 10.0},
    {"escape_speed", 0.5},
    {"unseen_speed", speed},
    {"override_max", 60.0},
    {"override_speed", 0.5},
    {"latency", 5.0},
    {"base_reaction", 5.0},
    {"angular_deceleration", 100.0},
    {"obstacle_speed", 5.0},
    {"noise", 0.2},
    {"memory_distance", 5.0},
    {"memory_time", 600.0},
    {"odometry_drift", 1.0},
    {"switch_release_time", 60.0},
};

}  // namespace

void check_bound(const std::string& name, double value, Problems& problems) {
  for (const Bound& bound : bounds) {
    if (name != bound.name) continue;
    problems.require(!(value > bound.most), words(name, " must be at most ", bound.most));
    problems.require(!(value < -bound.most), words(name, " must be at least ", -bound.most));
  }
}

}  // namespace safety_control_cloud
