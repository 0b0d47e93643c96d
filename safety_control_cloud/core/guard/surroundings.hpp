// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../look/outlook.hpp"
#include "../look/places.hpp"
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

/// What one look shows around the robot, from above, at its places when it was taken. One pass over the points, which
/// is another's too, into memory of one's own.
class Surroundings {
 public:
  Surroundings(const Outline& outline, Band band);

  /// A look begins, of a camera that is placed so in base_frame. What is to go alongside it, for as long as this is
  /// where it is.
  Alongside begin(const Outlook& outlook);

  /// All that was taken since it began is what is around the robot from now on; what was before is forgotten.
  void finish();

  /// From the innermost, which holds all that is inside the margin, cell by cell of a few millimetres.
  const std::vector<Ring>& rings() const { return rings_; }

 private:
  void take(Places& places);
  void leave_out_own(Places& places) const;

  Band band_;
  Region region_;
  Cells cells_;
  std::vector<Ring> rings_;
};

}  // namespace safety_control_cloud
