// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "backdrop.hpp"
#include "forgiving.hpp"
#include "patience.hpp"
#include "remembered.hpp"

namespace safety_control_cloud {

/// What came near, and what has become of it: each picture is asked about each thing.
///
/// - What is seen of a thing takes the place of what was seen of it. A thing of the same size has moved as a whole:
///   where it was, nothing is left of it, whatever returns there. What has become smaller may have a part that is too
///   near to return, which is lost.
/// - What is lost of a thing stays lost until the picture shows that it has gone: forgiving.hpp.
/// - What hung and has gone may have moved: where there is a hole of about its size in what was seen behind, it is lost
///   there, until that hole has closed.
/// - What the picture does not show, since it is another one than that in which the thing was seen, stays lost.
/// - What is near is kept. What is farther away is only watched: if a thing of fair extent, which nothing hides and
///   which is not at the border, returns nothing any more from one cloud to the next, it was not seen to go away. The
///   sensor is blind at the distance at which it was; it is kept, and that distance is near from then on, until a thing
///   is seen nearer. So is what leaves the picture at its lower border, of which nobody sees where it is from then on.
/// - While the camera turns, its picture says only what of the lost is seen again: not that anything has gone.
class ThingsMemory {
 public:
  /// Nearer than `near` [m] ahead of the camera is near.
  void update(std::vector<Thing> seen, const Pixels& picture, const NearFloor& floor, const Backdrop& backdrop,
              float near, Gaze gaze);
  /// In a picture most of which returns nothing, only what is seen counts: what is not may be there all the same.
  void update_by_little(std::vector<Thing> seen, const Pixels& picture, float near, const CameraPose& camera);
  /// Drops what has been lost for too long, and nothing else.
  void forget_old(const Patience& patience);

  const std::vector<Remembered>& things() const { return things_; }
  template <class Visit>
  void for_each_spot(Visit visit) {
    for (Remembered& thing : things_) {
      for (Spot& spot : thing.seen.spots) visit(spot);
      for (Spot& spot : thing.lost) visit(spot);
    }
  }
  /// Sizes are told but for the picture's angle; that of the next one is another.
  void scale_sizes(double by);
  /// The corridor leads elsewhere, by so much to the left [rad], and with it turn the axes that poses are told in.
  void turn_corridor(double angle);
  /// They are those of another frame from the next picture on, in which the camera, which has not moved, is there.
  void change_axes(const CameraPose& now);
  /// What has moved is lost where it is by now: what was seen behind is not known any more.
  void stay();
  bool empty() const { return things_.empty(); }
  /// The number of the latest picture.
  std::uint32_t picture() const { return picture_; }
  /// At which things vanished [m]; 0 if none did.
  float blind_range() const { return blind_range_; }
  /// These are remembered too, of which nothing is seen, since that camera was there.
  void add(std::vector<Remembered> things, float blind_range, const CameraPose& camera);
  /// So is what was never seen, and hid from these places on what is behind them.
  void add_unseen(std::vector<Spot> spots);

 private:
  float turning_to(const CameraPose& camera) const;
  static void lose(Remembered& thing, Thing before);
  static void stay_in_hole(Remembered& thing, std::vector<Spot> spots);
  void note_vanished(Remembered& thing, const Pixels& picture, float near, bool resting,
                     const std::optional<float>& nearer);
  void unlearn_blind_range();
  void drop_empty();

  std::vector<Remembered> things_;
  std::uint32_t picture_ = 0;
  float blind_range_ = 0.0f;
  std::optional<CameraPose> camera_;  ///< of the latest picture
  bool has_turned_ = false;           ///< the camera, or moved on the robot
};

}  // namespace safety_control_cloud
