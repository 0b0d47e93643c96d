// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guarded_robot.hpp"

namespace safety_control_cloud {

constexpr double quarter = 1.5707963267948966;

inline const Scene with_post({post(0.9f, 0.0f)});

inline Settings remembering(double distance = 1.5) {
  Settings settings = guard_settings();
  settings.memory_distance = distance;
  settings.unseen_speed = 0.7;
  return settings;
}

/// A robot with odometry that turns and stands where it is put, before a camera that shows what it is given. Who is put
/// a centimetre farther each time drives.
struct RobotWithOdometry : GuardedRobot {
  explicit RobotWithOdometry(const Settings& settings = remembering()) : GuardedRobot(settings) {}

  Pose2 pose;
  Twist2 twist;
  bool has_odometry = true;
  double odometry_ahead = 0.0;  ///< [s] its clock

  void passes(double seconds, const Scene& scene) {
    for (double t = 0.0; t < seconds; t += 0.05) {
      pass(0.05);
      const Point2 way = between(before_, pose).place;
      const bool drives = speed_of(twist) == 0.0 && length_of(way) < 0.011;
      const Twist2 told = drives ? Twist2{way.x / 0.05, way.y / 0.05, twist.w} : twist;
      if (has_odometry) control.note_odometry(now.ros + odometry_ahead, pose, told);
      before_ = pose;
      see(scene);
      wants({});
    }
  }

  void turns(double angle, const Scene& scene) {
    const int steps = 40;
    twist = {0.0, 0.0, angle / steps / 0.05};
    for (int i = 0; i < steps; ++i) {
      pose.heading += angle / steps;
      passes(0.05, scene);
    }
    twist = {};
  }

  const Guarded& asked(const Twist2& twist) {
    passes(0.5, hall);
    return wants(twist);
  }

  const Scene hall;

 private:
  Pose2 before_;
};

}  // namespace safety_control_cloud
