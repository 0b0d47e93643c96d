// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../look/field_of_view.hpp"
#include "../memory/loss.hpp"
#include "pose.hpp"

namespace safety_control_cloud {

/// Something that rests, and of which one knows where it is now.
struct KnownPlace {
  Point2 place;            ///< [m] in base_frame
  double height;           ///< [m] above it
  Point seen_from_camera;  ///< [m] in the frame of the camera that asks
  double off;              ///< [m] by which it may be displaced
  double shown_at = 0.0;   ///< [s] steady, last

  /// What may lie farther from its place tells nothing.
  bool tells_where_it_is() const { return off <= 0.05; }
};

/// Whether what is known to stand nearer than the camera can see (`blind_range` [m] ahead of it) hides all of the near
/// floor that is `covered`: then nothing else needs to stand there. Less than half a post's width may be left over, and
/// `left_over` of the picture's width.
bool hides(const std::vector<KnownPlace>& known, const std::vector<Span>& covered, const FieldOfView& field,
           double blind_range, double left_over = 0.0);

/// Until when [s] all of it is kept that hides anything, each for `time` [s] since it was shown, which none is after
/// `now`.
double kept_until(const std::vector<KnownPlace>& known, const FieldOfView& field, double blind_range, double time,
                  double now);

}  // namespace safety_control_cloud
