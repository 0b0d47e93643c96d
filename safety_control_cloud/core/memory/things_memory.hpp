// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "backdrop.hpp"
#include "evidence.hpp"
#include "moved.hpp"
#include "patience.hpp"

namespace safety_control_cloud {

/// A thing that came near, over many clouds.
struct Remembered {
  Thing seen;                    ///< as the latest cloud shows it that is not blind for it; no spots if it does not
  std::vector<Spot> lost;        ///< what was seen of it, and now is neither seen nor seen past
  double size = 0.0;             ///< [m2] at most
  double freed = 0.0;            ///< [m2] of the lost, since it was last seen, that is seen past by now
  unsigned clouds = 0;           ///< that have shown it
  bool stood = false;            ///< on the near floor, until it was seen to hang
  bool at_border = false;        ///< when it was seen last
  bool vanished = false;         ///< in mid-air: see ThingsMemory
  std::optional<Moved> moved{};  ///< none: it is lost where it was seen
  bool is_slight = false;        ///< of few pixels, which in a single cloud may be false

  bool is_seen() const { return !seen.spots.empty(); }
};

double size_of(const std::vector<Spot>& spots);  ///< [m2]

/// What came near, and what has become of it: each picture is asked about each thing.
///
/// - What is seen of a thing takes the place of what was seen of it. A thing of the same size has moved as a whole:
///   where it was, nothing is left of it, whatever returns there. What has become smaller may have a part that is too
///   near to return, which is lost.
/// - What is lost of a thing stays lost until the picture shows what is behind it, in three successive clouds, or at
///   once if it does so for nearly all of it. Then the rest goes too, unless most of that is a hole: something smaller
///   may have gone out of sight together with it.
/// - What hung and has gone may have moved: where there is a hole of about its size in what was seen behind, it is lost
///   there, until that hole has closed.
/// - Of a cloud that is not organised the picture is a raster, in which what is thin leaves no hole: it is not seen
///   past while nothing may return on the rays that it would take.
/// - What the picture does not show, since it is another one than that in which the thing was seen, stays lost.
/// - What leaves the picture at its upper border, within the corridor, is not seen to go by what is seen below it.
/// - What is near is kept. What is farther away is only watched: if a thing of fair extent, which nothing hides and
///   which is not at the border, returns nothing any more from one cloud to the next, it was not seen to go away. The
///   sensor is blind at the distance at which it was; it is kept, and that distance is near from then on, until a thing
///   is seen nearer.
/// - While the camera looks another way than when a spot was seen, or turns, its picture says nothing of it.
/// - What stands on the floor, in a column of the picture, has gone when the near floor is seen again in that column.
class ThingsMemory {
 public:
  struct NearFloor {
    /// Whether it is seen again in a column of the picture and nothing is near in it.
    std::function<bool(std::size_t column)> is_seen_again;
    const std::vector<std::size_t>& rows;  ///< of the picture, that show it
    std::uint8_t after = 1;                ///< so many clouds show it before it says anything of what is lost
  };

  /// Nearer than `near` [m] ahead of the camera is near.
  void update(std::vector<Thing> seen, const Pixels& picture, const NearFloor& floor, const Backdrop& backdrop,
              float near, const Axis& axis);
  /// In a picture most of which returns nothing, only what is seen counts: what is not may be there all the same.
  void update_by_little(std::vector<Thing> seen, const Pixels& picture, const Axis& axis);
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
  /// What has moved is lost where it is by now: what was seen behind is not known any more.
  void stay();
  bool empty() const { return things_.empty(); }
  /// At which things vanished [m]; 0 if none did.
  float blind_range() const { return blind_range_; }
  /// As they were written down; nothing of them is seen.
  void restore(std::vector<Remembered> things, float blind_range);

 private:
  std::vector<Thing> follow(std::vector<Thing> seen);
  static void lose(Remembered& thing, Thing before);
  void ask(Remembered& thing, const Pixels& picture, const NearFloor& floor, const Axis& axis);
  static void stay_in_hole(Remembered& thing, std::vector<Spot> spots);
  void note_vanished(Remembered& thing, const Pixels& picture, float near);
  void unlearn_blind_range();
  void drop_empty();

  std::vector<Remembered> things_;
  float blind_range_ = 0.0f;
  std::optional<Axis> axis_;  ///< of the latest picture
};

}  // namespace safety_control_cloud
