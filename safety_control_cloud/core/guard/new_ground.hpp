// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../path/outline.hpp"
#include "pose.hpp"

namespace safety_control_cloud {

/// Where a footprint, without its margin, comes to that it does not stand on now.
class NewGround {
 public:
  explicit NewGround(const Outline& outline);

  /// Whether any such place is one of these, after a way.
  template <class Is>
  bool any(const Pose2& way, Is is) const {
    const Turn turn(way.heading);
    for (const Point2& point : boundary_) {
      const Point2 place = way.place + turn(point);
      if (is_new(place) && is(place)) return true;
    }
    return false;
  }

 private:
  bool is_new(const Point2& place) const;

  const Outline& outline_;
  std::vector<Point2> boundary_;
};

}  // namespace safety_control_cloud
