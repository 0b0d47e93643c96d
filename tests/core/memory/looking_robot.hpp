// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../../../safety_control_cloud/core/safety_control.hpp"
#include "../scene.hpp"

namespace safety_control_cloud {

/// A robot that looks, a cloud every 50 ms.
class Robot {
 public:
  explicit Robot(const Settings& settings = {}, const Placing& placing = OpticalFrame{})
      : control_(settings), placing_(placing) {}

  Decision sees(const Scene& scene) { return sees(scene.view()); }
  Decision sees(const std::vector<Board>& boards) { return sees(Scene(boards)); }
  Decision sees(const CloudView& cloud) {
    now_ += 0.05;
    const double comes = now_ + late_;
    return control_.decide(cloud, Origin{now_, placing_}, Instant{comes, comes});
  }
  void waits(double seconds) { now_ += seconds; }
  void falls_behind(double seconds) { late_ += seconds; }  ///< what it sees comes later by so much from now on
  SafetyControl& control() { return control_; }

 private:
  SafetyControl control_;
  Placing placing_;
  double now_ = 100.0, late_ = 0.0;  ///< [s]
};

}  // namespace safety_control_cloud
