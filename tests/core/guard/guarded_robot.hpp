// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../../safety_control_cloud/core/guard_control.hpp"
#include "../scene.hpp"
#include "xtion.hpp"

namespace safety_control_cloud {

inline Settings guard_settings() {
  Settings settings;
  settings.mode = Mode::Guard;
  return settings;
}

/// A guarded robot that stands, and its time.
struct GuardedRobot {
  explicit GuardedRobot(const Settings& settings = guard_settings()) : control(settings) {}

  GuardControl control;
  Instant now{100.0, 1000.0};
  double stamp_behind = 0.0;  ///< [s]

  void pass(double seconds) { now.steady += seconds, now.ros += seconds; }

  void see(const CloudView& view, const Placing& placing = xtion(), std::size_t sensor = 0) {
    control.see(view, {now.ros - stamp_behind, placing, "camera", "camera_depth_optical_frame"}, now, sensor);
  }
  void see(const Scene& scene) { see(scene.view()); }

  /// As somebody says it again and again, and a camera that shows the same; until it has settled.
  const Guarded& drives(const Scene& scene, const Twist2& twist) {
    for (int i = 0; i < 10; ++i) drives_on(scene, twist);
    return wants(twist);
  }

  /// One cloud long.
  const Guarded& drives_on(const Scene& scene, const Twist2& twist) {
    pass(0.05);
    see(scene);
    return wants(twist);
  }

  const Guarded& wants(const Twist2& twist) {
    Command command;
    command.linear = {twist.vx, twist.vy, 0.0};
    command.angular[2] = twist.w;
    return is_told(command);
  }
  const Guarded& is_told(const Command& command) {
    control.want(command, now);
    return control.answer(now);
  }
};

/// A board from side to side, so far before the front of a TurtleBot [m].
inline Board wall_before(double front) { return {static_cast<float>(front + 0.265), -9.0f, 9.0f, -9.0f, floor_y}; }

}  // namespace safety_control_cloud
