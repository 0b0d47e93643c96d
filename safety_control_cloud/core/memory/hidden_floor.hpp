// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "floor_strip.hpp"
#include "gaze.hpp"
#include "loss.hpp"
#include "pixels.hpp"
#include "remembered.hpp"

namespace safety_control_cloud {

/// Where in the picture the lost of these things stand that were lost as the camera looks now, or nearer: floor that is
/// hidden there is hidden by them.
std::vector<Span> hidden_by(const std::vector<Remembered>& things, const Pixels& picture, const CameraPose& camera);

/// What hides the near floor, and was never seen itself: as long as the camera looks as it does, its picture says
/// whether it is still there. Once it looks elsewhere, other floor lies in the same rows: what was hidden is asked for
/// where it was. But what is dark wherever the camera glances is not: once it has looked elsewhere, only what was seen
/// to be hidden counts, of floor that was shown as the camera looks.
class HiddenFloor {
 public:
  /// Whether it may still be there, though the picture may show all of the floor, of a camera that turns.
  bool may_be_there() const { return has_turned_ && !spots_.empty(); }

  /// What is hidden in the picture of a camera that rests.
  const std::vector<Spot>& spots() const { return spots_; }
  /// Those, if the camera looks elsewhere by now; they are none of its picture's any more. And those of the picture
  /// before: it may have turned by the latest one, and TF not yet have said so.
  std::vector<Spot> left_behind(const CameraPose& camera);
  /// Those, wherever it looks.
  std::vector<Spot> take();

  /// Nothing returns in the rows of the strip where they are `covered`, and not hidden by the lost of `things`. What
  /// hides that lies in the corridor, nearer than `near` [m] ahead of the camera, for all that is known on the way to
  /// the floor. It has gone once some successive pictures show none: what a camera that turns shows may come before TF
  /// says that it has turned.
  void note(const FloorStrip& floor, const std::vector<Span>& covered, const std::vector<Remembered>& things,
            const Pixels& picture, const Gaze& gaze, float near);

 private:
  void note_shown(const FloorStrip& floor);

  std::optional<CameraPose> latest_;
  bool has_turned_ = false, has_looked_elsewhere_ = false;
  /// But for less than what counts as elsewhere; what follows was seen since.
  std::optional<CameraPose> looked_since_;
  std::vector<bool> shown_;                 ///< of each column of the strip, whether it showed the floor
  std::vector<Spot> spots_, spots_before_;  ///< of the latest picture that counts, and of the one before
  unsigned clouds_gone_ = 0;                ///< so many successive pictures show nothing covered
};

}  // namespace safety_control_cloud
