// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../input/scan.hpp"
#include "../look/field_of_view.hpp"
#include "../path/outline.hpp"
#include "bearings.hpp"

namespace safety_control_cloud {

/// Where a sensor looks, from above, in base_frame.
struct Eye {
  /// Where it does not look.
  struct Blind {
    Point2 direction;   ///< of length 1, to its middle
    double half_angle;  ///< [rad]
  };

  Point2 place;
  Point2 direction;         ///< of length 1; none (0, 0) if it looks straight up or down
  double half_angle = 0.0;  ///< [rad] to each side, the lesser

  std::vector<Blind> blind = {};  ///< between its sides, and beyond

  bool sees(const Point2& point) const { return looks_along(point - place); }
  bool looks_along(const Point2& there) const { return is_between_sides(there) && !is_in_a_gap(there); }
  /// Whether it would see a place, were it not for a gap: of a laser that looks at more than half a turn, the rest of
  /// the turn is one.
  bool misses(const Point2& point) const {
    return is_wide() ? !sees(point) : is_between_sides(point - place) && is_in_a_gap(point - place);
  }
  bool has_gaps() const { return is_wide() || !blind.empty(); }

 private:
  bool is_wide() const;
  bool is_between_sides(const Point2& there) const;
  bool is_in_a_gap(const Point2& there) const;
};

/// Of a camera that is placed in base_frame.
Eye eye_of(const Outlook& outlook, const FieldOfView& field);

/// Of a range finder, which has measured at these bearings lately.
Eye eye_of(const Outlook& outlook, const ScanView& scan, const Bearings& bearings);

/// Whether the footprint comes by a twist to where it is not now and all of that lies outside what the eye sees, at any
/// distance; or all of the robot moves away from where it looks; or it comes, within 1.5 m and a quarter of a turn, to
/// where all that is new to it lies in gaps between the eye's sides.
bool leads_into_the_unseen(const Outline& outline, const Eye& eye, const Twist2& twist);

/// Whether a twist leads ahead into what the eye sees, and not past it; of a turn in place, whether all that it leads
/// to is seen.
bool leads_to_where_it_looks(const Outline& outline, const Eye& eye, const Twist2& twist);

/// Whether no part of the robot comes nearer to where the eye looks: straight away from it, without turning.
bool leads_away_from(const Eye& eye, const Twist2& twist);

/// Whether the footprint comes nearer to it by a twist.
bool is_approached(const Point2& point, const Outline& outline, const Twist2& twist);

}  // namespace safety_control_cloud
