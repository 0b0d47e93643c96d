// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "guard/given.hpp"
#include "guard/guard.hpp"
#include "guard/looked_over.hpp"
#include "guard/odometry.hpp"
#include "guard/out_of_sight.hpp"
#include "guard/surroundings.hpp"
#include "latest_look.hpp"
#include "lost_from_sight.hpp"
#include "sensor.hpp"
#include "settings.hpp"

namespace safety_control_cloud {

/// One sensor of the guard: what it sees around the robot and whether that is to be believed, wherever it looks.
class GuardSensor {
 public:
  /// The settings are fit; `guard` was made of them.
  GuardSensor(const SensorSettings& sensor, const Settings& settings, const Guard& guard);

  /// Goes on with other settings for all.
  void adopt(const Settings& settings, const Guard& guard);

  /// A reading has come, readable or not, at a robot that was `given` this. What it shows, if that is believed.
  std::optional<Look> see(const Reading& reading, const Origin& origin, const Instant& now, const Given& given);

  /// What it saw last was seen with the robot there; none: nobody knows. Whether something is lost from its sight.
  bool note_pose(const std::optional<Pose2>& pose, double now);

  /// Its latest reading, which may be blind, was taken from there.
  void note_picture_from(const Outlook& outlook, const Pose2& pose, double now);

  /// What is known to be around it there: if that is all that is lost, nothing is.
  void explain_loss(const std::vector<KnownPlace>& known, double now);

  /// Whether the top of something low meets its picture's lower border.
  bool looks_over_any() const { return !sensor_.ends_below().empty(); }

  /// What was seen to rest around it as its latest picture was taken.
  void note_fronts(const std::vector<KnownPlace>& known, double now);

  /// How it is placed, if it has been blind since it was sound last; none: it sees, or something else is the matter.
  std::optional<Outlook> outlook_if_blind(const Placing& placing) const;

  /// What is known to be around it where it is blind: if that hides all from it, only the way ahead is closed.
  void explain_blindness(const std::vector<KnownPlace>& known, double now);

  /// Where the robot was is not known any more.
  void forget_poses() { lost_.forget_poses(); }

  /// None has come until `now`.
  void wait(const Instant& now);

  /// What speaks against it that its readings do not tell; none: nothing any more.
  void note_outside(std::optional<Doubt> doubt) { outside_ = std::move(doubt); }

  /// What it lets one know, given where the robot went.
  Known known_at(const Instant& now, const Odometry& odometry, const Given& given) const;

  /// Of what it lets one know while it is in doubt and not required: what it had lost from sight before closes every
  /// way but away from there all the same, and so does what was near when it went blind; none: there is no such thing,
  /// or it is kept as places. `now` [s] steady.
  std::optional<Known> left_behind(const Known& known, double now) const;

  /// Whether what it shows was taken after this stamp [s, ROS], or that it is blind, so that only away from where it
  /// looks is open.
  bool has_looked_since(double stamp) const;

  /// [s, ROS] When a reading was taken that comes now, as far as its stamp is believed.
  double taken_at(const Origin& origin, const Instant& now) const;

  /// Whether it was sound until the settings changed, and has not looked since.
  bool is_awaited() const {
    return taken_ && collected_ == Collected::Nothing && std::holds_alternative<Seen>(sensor_.answer());
  }

  /// Whether what it lets one know is its latest look.
  bool shows() const { return collected_ == Collected::Now; }

  /// Where it looked last; none: it shows nothing.
  std::optional<Eye> eye() const { return taken_ ? std::optional(taken_->eye) : std::nullopt; }

  /// See LatestLook.
  bool misses(const Point2& place, const Heights& heights, double off) const;

  const Law& law() const { return law_; }

  /// [s] until it counts as silent; infinite if it does, or has never sent anything.
  double until_silent(double now) const;

  void forget_losses();
  std::string remembered() const;
  /// A laser, which remembers nothing, goes on with nothing either.
  bool recall(const std::string& remembered);

  const std::string& name() const { return about_.name; }
  bool is_required() const { return about_.required; }
  const Sight& counted() const { return sensor_.counted(); }

 private:
  /// By the present settings. Of a sensor that has been blind ever since, what it showed before tells where it looks.
  enum class Collected { Nothing, Before, Now };

  Eye eye_on_what_is_lost() const;
  std::vector<Point2> ends_below() const;
  void face(const Reading& reading, const Placing& placing);
  Look take(const Reading& reading, const Origin& origin, const Outlook& outlook, const Instant& now,
            const Given& given);

  SensorSettings about_;
  Settings own_;
  Settings straight_;  ///< by which all of its points are taken, whichever way it looks
  Law law_;
  double facing_ = 0.0;  ///< [rad] from base_frame's x axis: where the corridor leads that it looks down
  Sensor sensor_;
  Surroundings around_;
  Bearings bearings_;  ///< of a range finder
  std::optional<LatestLook> taken_;
  Collected collected_ = Collected::Nothing;
  LostFromSight lost_;
  LookedOver looked_over_;
  bool is_new_picture_ = false;         ///< the latest reading: something may be remembered of it
  std::optional<double> last_arrival_;  ///< [s] steady
  double last_taken_ = 0.0;             ///< [s] ROS
  std::size_t looks_ = 0;               ///< that were taken
  std::optional<Doubt> outside_;
};

}  // namespace safety_control_cloud
