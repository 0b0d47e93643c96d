// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "entry.hpp"
#include "outline.hpp"
#include "twist.hpp"

namespace safety_control_cloud {

/// What the widened footprint sweeps while a twist lasts: the sum of the footprint and a disc of the margin's radius,
/// sides moved outward and arcs around the corners. Made once for a twist and asked for many points.
class Sweep {
 public:
  /// `widening` [m] is added to the footprint's margin; no less than 0. Nothing is asked beyond `horizon` [s].
  Sweep(const Outline& outline, const Twist2& twist, double widening = 0.0,
        double horizon = std::numeric_limits<double>::infinity());

  /// [s] of the twist until a resting point is touched; infinite if it is not within a full turn or the horizon. 0 for
  /// a point that is inside already. One that is on the boundary (within `touch`) is touched only if it moves inward.
  /// A point that is not finite, and every point under a twist that is not sound, is touched at once. Points farther
  /// than 1000 km are never reached. Who asks for the first of many need not know of contacts after `before` [s]: those
  /// may read as infinite.
  double time_to_contact(const Point2& point, double before = std::numeric_limits<double>::infinity()) const;

  double margin() const { return margin_; }  ///< [m] from the footprint, with the widening

 private:
  /// A side moved outward. In its own axes, outward x and along s, a point's coefficients are linear.
  struct MovedSide {
    Point2 outward, along;
    double offset;              ///< [m] of x
    double first, last;         ///< [m] of s
    double antipode;            ///< Crossing.a without the point
    double inward_speed;        ///< [m/s] Crossing.b without the point
    double speed_along;         ///< [m/s] of the robot
    double turned_speed_along;  ///< [m/s] along the side, of the robot's velocity turned left
  };

  double squared_reach(double time) const;
  bool may_be_reached(const Point2& point, double squared_distance, double before) const;
  std::optional<Moment> entry_through(const MovedSide& side, const Point2& point,
                                      const std::optional<Moment>& earliest) const;
  std::optional<Moment> entry_around(const Point2& corner, const Point2& point) const;
  MovedSide moved_outward(const Side& side) const;
  void find_lane(double margin);
  double lane_of(const Point2& point) const;

  Outline outline_;
  Twist2 twist_;
  Point2 velocity_turned_;               ///< [m/s] the robot's, turned left
  double half_rate_;                     ///< [rad/s] w / 2
  double margin_;                        ///< [m] from the sides and corners, with the radius of a circle
  double horizon_;                       ///< [s]
  double speed_;                         ///< [m/s] at most at which a point comes nearer to the origin
  double extent_;                        ///< [m] from the origin, of the widened footprint
  double squared_reach_;                 ///< [m2] from the origin, of all that may be touched within the horizon
  double nearest_lane_, farthest_lane_;  ///< of the widened footprint
  std::vector<MovedSide> sides_;
  bool is_sound_;
};

}  // namespace safety_control_cloud
