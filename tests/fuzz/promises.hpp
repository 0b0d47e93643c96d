// SPDX-License-Identifier: BSD-3-Clause
// What must hold of every decision; what does not is told, and ends the fuzzer.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "../../safety_control_cloud/core/safety_control.hpp"
#include "../../safety_control_cloud/core/speed/speed.hpp"

namespace safety_control_cloud {

inline void require(bool holds, const char* sentence) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", sentence);
  std::abort();
}

inline bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

inline void require_same(const std::optional<Obstacle>& a, const std::optional<Obstacle>& b) {
  require(a.has_value() == b.has_value(), "one method sees an obstacle and the other none");
  if (!a) return;
  const Point &p = a->point, &q = b->point;
  require(same(p.x, q.x) && same(p.y, q.y) && same(p.z, q.z), "both methods find the same nearest point");
}

inline void require_same(const Decision& a, const Decision& b) {
  require(a.cause == b.cause && a.reason == b.reason, "both methods give the same cause");
  require(a.zone == b.zone && a.speed == b.speed, "both methods give the same zone and speed");
  require_same(a.nearest, b.nearest);
  require_same(a.sight.nearest, b.sight.nearest);
  require(a.sight.returns == b.sight.returns && a.sight.total == b.sight.total, "both methods count the same returns");
  require(a.sight.inside == b.sight.inside, "both methods count the same points inside");
  require(a.sight.too_close == b.sight.too_close, "both methods count the same points that are too close");
  require(a.sight.nearest_in_rows == b.sight.nearest_in_rows, "both methods see the same nearest in each row");
}

inline bool has_looked(const Decision& decision) {
  const auto causes_of_sight = {Cause::Seen, Cause::NearLoss, Cause::LowObstacle};
  return std::find(causes_of_sight.begin(), causes_of_sight.end(), decision.cause) != causes_of_sight.end();
}

inline void require_safe(const Decision& decision, const Settings& settings) {
  require(decision.speed == speed_for(decision.zone, settings.speeds), "the speed is the zone's");
  require(has_looked(decision) || (decision.speed == 0.0 && decision.zone == Zone::Danger),
          "in doubt the robot stands");
  require(!decision.reason.empty(), "every decision has a reason");
  if (!has_looked(decision) || !decision.nearest) return;
  require(decision.zone <= zone_at(decision.nearest->distance(), settings.limits),
          "no zone is better than its obstacle");
  if (decision.sight.crop) require(decision.sight.crop->size() == decision.sight.inside, "the crop is what is inside");
}

/// Whether something near that is not seen any more keeps the robot where it is under these settings.
inline bool keeps(const Settings& settings) {
  return settings.near_loss.distance >= 0.75 && settings.near_loss.timeout == 0.0 && settings.target_frame.empty();
}

}  // namespace safety_control_cloud
