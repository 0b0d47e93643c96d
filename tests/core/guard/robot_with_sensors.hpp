// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "../../../safety_control_cloud/core/input/angle.hpp"
#include "guarded_robot.hpp"

namespace safety_control_cloud {

/// In base_frame, turned by so much around it.
inline Placing turned_xtion(double heading) {
  const double c = std::cos(heading), s = std::sin(heading);
  Eigen::Matrix<double, 3, 4> place;
  place << s, 0, c, -0.087 * c, -c, 0, s, -0.087 * s, 0, -1, 0, 0.2972;
  return placing_of(place);
}

inline Placing laser_at(double height, double tilt = 0.0, double ahead = 0.0) {
  const double c = std::cos(tilt), s = std::sin(tilt);
  Eigen::Matrix<double, 3, 4> place;
  place << c, 0, s, ahead, 0, 1, 0, 0.0, -s, 0, c, height;
  return placing_of(place);
}

constexpr std::size_t front = 0, rear = 1, laser = 2;

inline Settings with_sensors(bool laser_is_required = true) {
  Settings settings = guard_settings();
  settings.sensors = {{"front", InputKind::Cloud, "front/points", true, {}},
                      {"rear", InputKind::Cloud, "rear/points", false, {}},
                      {"laser", InputKind::Scan, "scan", laser_is_required, {{"noise", 0.02}}}};
  return settings;
}

/// All three sensors show; a laser of 360 beams.
struct RobotWithSensors : GuardedRobot {
  explicit RobotWithSensors(const Settings& settings = with_sensors()) : GuardedRobot(settings) {}

  Scene ahead, behind;
  std::vector<float> ranges = std::vector<float>(360, 5.0f);
  ScanPoints scans;
  double first_bearing = -pi, range_min = 0.1, range_max = 10.0;
  Placing laser_place = laser_at(0.2);
  double rear_heading = pi;
  bool front_shows = true, rear_shows = true, laser_shows = true;

  /// Something narrow, at the laser's left.
  void shows_beside_it() {
    for (std::size_t degrees = 267; degrees <= 273; ++degrees) ranges[degrees] = 0.35f;
  }

  void see_scan(std::size_t sensor = laser) {
    Scan scan;
    scan.angle_min = first_bearing, scan.angle_increment = 2.0 * pi / 360.0;
    scan.angle_max = first_bearing + static_cast<double>(ranges.size() - 1) * scan.angle_increment;
    scan.scan_time = 0.1, scan.range_min = range_min, scan.range_max = range_max;
    scan.ranges = ranges.data(), scan.size = ranges.size();
    control.see(scans.of(scan), {now.ros, laser_place, "laser", "laser"}, now, sensor);
  }

  /// As somebody says it again and again, and sensors that show the same; until it has settled.
  const Guarded& drives(const Twist2& twist) {
    for (int i = 0; i < 10; ++i) drives_on(twist);
    return wants(twist);
  }

  /// One look of each long.
  const Guarded& drives_on(const Twist2& twist) {
    pass(0.05);
    if (front_shows) see(ahead.view(), xtion(), front);
    if (rear_shows) see(behind.view(), turned_xtion(rear_heading), rear);
    if (laser_shows) see_scan();
    return wants(twist);
  }
};

}  // namespace safety_control_cloud
