// SPDX-License-Identifier: BSD-3-Clause
#include "stopping.hpp"

namespace safety_control_cloud {

double stopping_distance(double speed, double source_timeout, const Stopping& stopping) {
  const double reaction = stopping.sensor_period + source_timeout + stopping.base_timeout;
  return speed * reaction + speed * speed / (2.0 * stopping.base_deceleration);
}

}  // namespace safety_control_cloud
