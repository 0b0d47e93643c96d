// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "outline.hpp"

namespace safety_control_cloud {

/// Which points count, where to say so takes longer than to see that most of them lie beside the way: found out once
/// for each that somebody asks for. None given: all do.
class Condition {
 public:
  explicit Condition(std::function<bool(const Point2&)> counts = {}) : counts_(std::move(counts)) {}

  /// Of the same points each time.
  bool holds_for(const std::vector<Point2>& points, std::size_t i) const;

 private:
  enum class Known : std::uint8_t { Not, Counts, CountsNot };
  std::function<bool(const Point2&)> counts_;
  mutable std::vector<Known> known_;
};

/// Returns of one look, seen from above, as places of which each may stand for several.
struct Obstacles {
  std::vector<Point2> points;
  std::vector<std::uint32_t> counts;  ///< returns that each point stands for; empty: one each
  double widening = 0.0;              ///< [m] how far from its point a return may lie
  Condition condition = Condition();
};

/// One point for each cell of a grid: the middle of the cell's returns, with how far the farthest lies from it. A sweep
/// that is widened by that much touches the point no later than any of its returns. What is not finite stays as it is.
/// `cell` [m] more than 0.
Obstacles reduced(const std::vector<Point2>& points, double cell);

/// Those within `distance` [m] of the footprint, and the rest. A motion that only leads away from what is inside the
/// margin (escape.hpp) needs the near ones as they are; the far ones may be reduced.
struct Parted {
  std::vector<Point2> near;
  std::vector<Point2> far;
};
Parted parted(const std::vector<Point2>& points, const Outline& outline, double distance);

/// A part of the robot that a sensor may see, a mast or an arm, in base_frame [m].
struct OwnBox {
  double x_min, x_max, y_min, y_max, z_min, z_max;
};

/// Limits inclusive. What is not finite lies in none.
inline bool is_own(const std::vector<OwnBox>& self, double x, double y, double z) {
  for (const OwnBox& box : self) {
    if (x >= box.x_min && x <= box.x_max && y >= box.y_min && y <= box.y_max && z >= box.z_min && z <= box.z_max)
      return true;
  }
  return false;
}

}  // namespace safety_control_cloud
