// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../input/view.hpp"
#include "../look/outlook.hpp"
#include "../path/obstacles.hpp"
#include "../path/outline.hpp"
#include "cells.hpp"

namespace safety_control_cloud {

/// Which returns count, in base_frame.
struct Band {
  double bottom, top;        ///< [m] heights, inclusive
  double reach;              ///< [m] farther than this nothing matters
  std::vector<OwnBox> self;  ///< of the robot itself
};

/// Obstacles out to an extent: the nearer they are, the less they are reduced.
struct Ring {
  double extent;  ///< [m] to each side of base_frame's origin, of the square that holds them
  Obstacles obstacles;
  std::size_t returns = 0;  ///< that they stand for
};

/// What one look shows around the robot, from above, at its places when it was taken. One pass over the points, into
/// memory of one's own.
class Surroundings {
 public:
  Surroundings(const Outline& outline, Band band);

  /// The points of a view whose camera is placed in base_frame; what was seen before is forgotten.
  void look(const View& view, const Outlook& outlook);

  /// From the innermost, which holds all that is inside the margin, cell by cell of a few millimetres.
  const std::vector<Ring>& rings() const { return rings_; }

 private:
  /// A return in base_frame, if it counts.
  void add(float forward, float left, float up);

  Band band_;
  float bottom_, top_;  ///< the band's
  std::vector<Cells> cells_;
  std::vector<Ring> rings_;
};

}  // namespace safety_control_cloud
