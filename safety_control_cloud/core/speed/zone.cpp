// SPDX-License-Identifier: BSD-3-Clause
#include "zone.hpp"

#include <algorithm>

namespace safety_control_cloud {

const char* name_of(Zone zone) {
  if (zone == Zone::Safe) return "Safe";
  if (zone == Zone::Warning) return "Warning";
  return "Danger";
}

Zone zone_at(double distance, const ZoneLimits& limits) {
  if (distance > limits.warning) return Zone::Safe;
  if (distance > limits.danger) return Zone::Warning;
  return Zone::Danger;  // NaN too: it compares as not greater
}

Zone ZoneLatch::update(Zone seen, double now) {
  if (seen <= zone_) {
    better_clouds_ = 0;
    return zone_ = seen;
  }
  if (better_clouds_ == 0) {
    better_since_ = now;
    worst_of_better_ = seen;
  }
  ++better_clouds_;
  worst_of_better_ = std::min(worst_of_better_, seen);
  if (better_clouds_ < hold_.clouds || now - better_since_ < hold_.time) return zone_;
  better_clouds_ = 0;
  return zone_ = worst_of_better_;
}

}  // namespace safety_control_cloud
