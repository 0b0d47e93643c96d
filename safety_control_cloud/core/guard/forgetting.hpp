// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "looks_taken.hpp"
#include "near_returns.hpp"
#include "remembered_place.hpp"
#include "seen_at.hpp"
#include "whereabouts.hpp"

namespace safety_control_cloud {

/// What becomes of places that the latest look does not show.
class Forgetting {
 public:
  /// `by_look`: by how far the robot may have been elsewhere as the look was taken. `now` [s] steady; `time` [s] for
  /// which a place is kept. Borrows the rest.
  Forgetting(const Look& look, const SeenAt& seen_at, const LooksTaken& looks, const Whereabouts& robot,
             const Drift& by_look, double now, double time);

  /// Whether a place has gone. If not, it goes on with what the look tells of it.
  bool has_gone(RememberedPlace& place);

 private:
  /// A place around the robot, and as the sensor has it.
  struct Asked {
    Point2 here;
    Point there;
    double range, off;  ///< [m] from the robot, and in depth, by how much it may lie elsewhere
  };

  bool showed_it(const RememberedPlace& place) const;
  bool is_shown_by_another(const RememberedPlace& place) const;
  bool is_asked_of(const RememberedPlace& place) const;
  double measured_from(const Point& there) const;
  Point from_camera(const Point2& here, float height) const;
  AtPlace seen_of(const RememberedPlace& place, const Asked& asked);
  double unknown_drift(const RememberedPlace& place) const;
  bool grows_old(const RememberedPlace& place) const;
  void keep_with_what_is_shown(RememberedPlace& place, double off) const;
  bool is_proven(RememberedPlace& place, AtPlace seen, bool is_measured) const;

  const Look& look_;
  const SeenAt& seen_at_;
  const LooksTaken& looks_;
  std::size_t sensor_;  ///< whose look is the latest
  bool is_scan_;
  const Whereabouts& robot_;
  Drift by_look_;
  double now_, time_;
  SeenAfter seen_after_;
  WaySince way_since_;
};

}  // namespace safety_control_cloud
