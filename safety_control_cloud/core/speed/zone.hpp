// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "settings.hpp"

namespace safety_control_cloud {

/// Ordered: a smaller zone is a worse one.
enum class Zone : std::uint8_t { Danger = 0, Warning = 1, Safe = 2 };

const char* name_of(Zone zone);  ///< "Danger", "Warning" or "Safe"

Zone zone_at(double distance, const ZoneLimits& limits);

/// Worsens at once and recovers only after the hold, and then to the worst zone seen during it.
class ZoneLatch {
 public:
  explicit ZoneLatch(const Hold& hold) : hold_(hold) {}

  Zone update(Zone seen, double now);  ///< now [s] on a clock that never goes back
  void hold(const Hold& hold) { hold_ = hold; }

 private:
  Hold hold_;
  Zone zone_ = Zone::Danger;
  Zone worst_of_better_ = Zone::Safe;
  std::size_t better_clouds_ = 0;
  double better_since_ = 0.0;
};

}  // namespace safety_control_cloud
