// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "loss.hpp"

namespace safety_control_cloud {

/// The nearest obstacle of clouds that are not organised, kept from when it was near until something is seen behind it;
/// another one, farther away, does not take its place before.
class KeptNearest {
 public:
  /// Whether it is lost in this cloud. Nearer than `near_distance` [m] is near.
  std::optional<Loss> judge(const View& view, const Sight& sight, const Corridor& corridor, const Gaze& gaze,
                            double near_distance);

 private:
  void keep(const std::optional<Obstacle>& nearest, double near_distance);

  std::optional<Obstacle> nearest_;
};

}  // namespace safety_control_cloud
