// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "guard/lost_spots.hpp"
#include "latest_look.hpp"
#include "sensor.hpp"

namespace safety_control_cloud {

/// What one of the guard's sensors has lost from sight, and whether that is all known to rest somewhere: then it closes
/// the way there and no other.
class LostFromSight {
 public:
  /// The sensor has answered so to a reading. `is_any_near`: something was when it saw last.
  void note(const Answer& answer, bool is_any_near);

  /// It has answered so to none.
  void note_silence(const Answer& answer);

  /// It goes on with what another process remembered, and may have lost some of it.
  void note_recalled(bool is_any_lost);

  /// The latest picture, of this number, was taken from there.
  void note_picture(std::uint32_t number, const LostSpots::Taken& from) { spots_.note_picture(number, from); }

  /// What it saw last was seen with the robot there; none: nobody knows. Whether something is lost.
  bool note_pose(const Answer& answer, const std::optional<Pose2>& pose, double now);

  /// What is known to be around it there, and for how long such is kept [s]: if that is all that is lost, nothing is.
  /// `blind_range` [m].
  void explain(const Answer& answer, const std::vector<KnownPlace>& known, const LatestLook& look, double blind_range,
               double time, double now);

  /// The same of a camera that is blind, and counted so few returns: if that hides all from it, only the way ahead is
  /// closed.
  void explain_blindness(const Sight& counted, const std::vector<KnownPlace>& known, const FieldOfView& field,
                         double blind_range, double time, double now);

  /// What was known is kept within other limits, and nobody knows what of it.
  void forget_explanation() { explained_until_.reset(); }

  /// Where the robot was is not known any more.
  void forget_poses();

  /// Somebody has looked: nothing is lost.
  void forget();

  /// Why a sensor that saw until now is not to be believed where it looks, and only there.
  std::optional<Doubt> doubt(const Answer& answer, std::size_t min_points) const;

  /// Something, or it is blind before what was near.
  bool has_any() const { return has_any_; }
  /// Something in its corridor, of which nobody knows where it is.
  bool is_ahead() const { return is_ahead_; }
  /// All of it was known at the latest reading, or why the sensor was blind then.
  bool is_explained() const { return explained_until_.has_value(); }
  /// And is known by `now` [s], though the sensor may have said nothing since.
  bool is_still_explained(double now) const { return explained_until_ && now <= *explained_until_; }
  /// Nothing but what it cannot see any more speaks against the sensor.
  bool was_sound() const { return was_sound_; }
  /// That it is blind, and only that.
  bool is_blind_only(const Answer& answer) const;

 private:
  void judge(const Answer& answer);
  bool is_known(const Loss& lost, const std::vector<KnownPlace>& known, const Looking& looking, double time,
                double now) const;

  LostSpots spots_;
  std::optional<Pose2> pose_;  ///< of the robot, as it looked last
  bool has_any_ = false, is_ahead_ = false, was_sound_ = false;
  std::optional<double> explained_until_;  ///< [s] steady: then the first of the places are forgotten that explain it
};

}  // namespace safety_control_cloud
