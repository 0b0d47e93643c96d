// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "footprint.hpp"
#include "segment.hpp"
#include "twist.hpp"

namespace safety_control_cloud {

/// A side of a polygon, the robot to the left of it.
struct Side {
  Segment segment;
  Point2 along;    ///< of length 1
  Point2 outward;  ///< of length 1
};

/// The boundary of a sound footprint, which is all that a resting point can run into.
/// A circle is a polygon with no sides and one corner, its centre, and with its radius as part of the margin.
class Outline {
 public:
  /// Throws std::invalid_argument with all problems_in(footprint), if there are any.
  explicit Outline(const Footprint& footprint);

  const std::vector<Side>& sides() const { return sides_; }
  const std::vector<Point2>& round_corners() const { return round_corners_; }  ///< those that stick out
  double radius() const { return radius_; }                                    ///< [m] of a circle, else 0
  double margin() const { return margin_; }                                    ///< [m]

  /// [m] from base_frame's origin to what lies farthest from it.
  double reach() const { return reach_; }
  /// [m] the same for what moves when the robot turns about that origin: a circle's outline stays where it is.
  double turning_reach() const { return sides_.empty() ? 0.0 : reach_; }

  /// [m] from the footprint without its margin; inside, less than 0 by the distance to the nearest side.
  double signed_distance(const Point2& point) const;

 private:
  std::vector<Side> sides_;  ///< one after the other, anticlockwise
  std::vector<Point2> round_corners_;
  double radius_ = 0.0;
  double margin_ = 0.0;
  double reach_ = 0.0;
};

/// [m/s] of the fastest point of the footprint.
double fastest_point(const Outline& outline, const Twist2& twist);

}  // namespace safety_control_cloud
