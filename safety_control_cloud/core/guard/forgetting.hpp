// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "looks_taken.hpp"
#include "near_returns.hpp"
#include "remembered_place.hpp"
#include "seen_at.hpp"
#include "whereabouts.hpp"

namespace safety_control_cloud {

constexpr std::uint8_t believed = 2;  ///< looks that show a place, or what is behind it
constexpr double well_placed = 0.02;  ///< [m] odometry that drifted by no more has a place where it is
constexpr double well_known = 0.2;    ///< [m] what may be off by more explains nothing that is lost, nor grows younger

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
  Point from_camera(const Point2& here, float height) const;
  AtPlace seen_of(const RememberedPlace& place, const Point2& here, const Point& there, double range, double by_way);
  double beside(const RememberedPlace& place, double range, double by_way) const;
  double unknown_drift(const RememberedPlace& place) const;
  bool grows_old(const RememberedPlace& place) const;
  void keep_with_what_is_shown(RememberedPlace& place, double off) const;
  bool is_proven(RememberedPlace& place, AtPlace seen, bool is_measured) const;

  const Look& look_;
  const SeenAt& seen_at_;
  const LooksTaken& looks_;
  const Whereabouts& robot_;
  Drift by_look_;
  double now_, time_;
  SeenAfter seen_after_;
  WaySince way_since_;
};

}  // namespace safety_control_cloud
