// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "../look/field_of_view.hpp"
#include "../look/outlook.hpp"
#include "../memory/loss.hpp"
#include "eye.hpp"
#include "known_places.hpp"
#include "pose.hpp"

namespace safety_control_cloud {

/// How a camera looks that has lost something.
struct Looking {
  Pose2 pose;  ///< of the robot
  Outlook camera;
  FieldOfView field;
  Eye eye;
  double blind_range;  ///< [m]
};

/// Where in a frame that rests the things are that a camera has lost from sight.
class LostSpots {
 public:
  /// How the camera was placed, and where the robot was, when a picture was taken.
  struct Taken {
    Outlook camera;
    Pose2 pose;
    double at;  ///< [s] steady
  };

  /// The latest picture, of this number, was taken from there. Of many, the first are forgotten.
  void note_picture(std::uint32_t number, const Taken& from);

  /// They are lost now, or since soon after their picture, if that is longer ago. Of those of a picture that was not
  /// noted, nobody knows where they are. `now` [s] steady.
  void note(const std::vector<LostSpot>& lost, double now);

  /// Where they are, nobody knows any more: the frame is another one.
  void forget_places();

  /// Whether nearly all of them are among what is known around a robot and was shown last when they were, or just where
  /// it has been shown since: the rest of a long thing, which is still shown, tells nothing of its end, but a robot
  /// that backs off sees again what it had lost. What would be shown if it still rested a little beyond the blind
  /// range, and is not, tells nothing either. None of them is of which nobody knows where it is, however many others
  /// are: of what was lost before a restart few spots are left. After `time` [s], when places are forgotten, none is
  /// known but what lies elsewhere than where the eye looks: one that is left would speak for another beside it.
  bool are_among(const std::vector<KnownPlace>& known, const Looking& looking, double time, double now) const;

  /// Until when all their places are kept that are kept by `now`, each for `time` [s].
  double kept_until(double time, double now) const;

  /// Whether the camera would see some of them if they rested where they were, a little beyond its blind range, and
  /// nothing is known to have been shown there since: they have moved, and may have come nearer than it sees.
  bool have_moved(const std::vector<KnownPlace>& known, const Looking& looking) const;

 private:
  struct Lost {
    std::optional<Point2> place;
    double height, since;  ///< [m] above base_frame, [s]
  };

  static bool is_forgotten(const Lost& lost, double time, double now);

  std::map<std::array<float, 3>, Lost> spots_;  ///< by where they were seen
  std::map<std::uint32_t, Taken> pictures_;
};

}  // namespace safety_control_cloud
