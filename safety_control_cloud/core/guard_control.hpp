// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "guard/command.hpp"
#include "guard/given.hpp"
#include "guard/guard.hpp"
#include "guard/override.hpp"
#include "perception.hpp"
#include "settings.hpp"

namespace safety_control_cloud {

/// What the guard lets through, and why no more.
struct Guarded {
  Command wanted, given;
  double factor = 0.0;           ///< given is so much of wanted; 1 if nothing was taken from it
  double time_to_contact = 0.0;  ///< [s] of wanted; infinite if nothing is touched before the robot could stand
  std::optional<Point2> point;   ///< [m] in base_frame, that decided
  std::string sensor;            ///< that decided; empty: none did
  Cause cause = Cause::NoCloud;
  std::string reason;
  std::string hint;                 ///< what would free it, if it stands for what nobody sees any more
  bool in_view = false;             ///< some sensor looks where what is wanted leads
  bool stuck = false;               ///< something is wanted and nothing is given
  double stuck_since = 0.0;         ///< [s, steady] if it is
  std::uint8_t open = 0;            ///< while it is: bits of the directions in which it may move (guard/directions.hpp)
  double override_left = 0.0;       ///< [s] for which what is seen is not asked; 0: it is
  Sight sight;                      ///< what the latest reading held: of the sensor that decided, or of the first
  std::vector<std::string> doubts;  ///< what speaks against odometry or a sensor that is not required, its name first
};

/// The guard: what sensors see, what the base is told and does, what somebody wants; and of that, what is safe. Needs
/// no ROS and no clock: the time is an argument.
class GuardControl {
 public:
  /// Throws std::invalid_argument with all problems_in(settings), if there are any.
  explicit GuardControl(const Settings& settings);

  /// A reading of one of sensors_of(settings) has come, readable or not.
  void see(const Reading& reading, const Origin& origin, const Instant& now, std::size_t sensor = 0) {
    perception_.see(reading, origin, now, sensor, given_);
  }

  /// Somebody wants this; `stamp` [s, ROS]: of a command that has one.
  void want(const Command& wanted, const Instant& now, std::optional<double> stamp = std::nullopt);

  /// Nobody listened for so long [s] until now, nor told the base anything, or so that this knows of it.
  void note_deafness(double seconds, const Instant& now) { perception_.note_deafness(seconds, now, given_); }

  /// The base says where it is, or a part of it, on which base_frame is at `base`.
  void note_odometry(double stamp, const Pose2& pose, const Twist2& twist, const Pose2& base = {}) {
    perception_.odometry().note(stamp, beyond(pose, base), twist_of_part(twist, base), given_.fastest_of_late());
  }

  /// The same of whom tells poses alone.
  void note_pose(double stamp, const Pose2& pose) {
    perception_.odometry().note_pose(stamp, pose, given_.fastest_of_late());
  }

  /// What is in doubt outside of the sensors. From the next answer on the robot stands for it, until there is none.
  void note_outside(std::optional<Doubt> doubt) { perception_.note_outside(std::move(doubt)); }

  /// What speaks against a sensor that its readings do not tell, until there is none.
  void note_about(std::size_t sensor, std::optional<Doubt> doubt) {
    perception_.sensor(sensor).note_outside(std::move(doubt));
  }

  /// Of one of the settings' switches: what one who speaks for it says of an edge, and whether that is new; who alone
  /// could at `as_of` [s, steady]; what speaks against it.
  bool note_switch(std::size_t which, const std::string& who, Edge edge, bool touched, const Instant& now) {
    return perception_.switches().note(which, who, edge, touched, now.steady);
  }
  void note_switch_living(std::size_t which, const std::vector<std::string>& who, double as_of) {
    perception_.switches().note_living(which, who, as_of);
  }
  void note_about_switch(std::size_t which, std::optional<Doubt> doubt) {
    perception_.switches().note_outside(which, std::move(doubt));
  }

  /// Somebody asks that for a while nobody asks what is seen.
  OverrideReply ask_override(const OverrideWish& wish, const Instant& now);

  /// What holds now. It is taken for said: the robot is held to do it from now on.
  const Guarded& answer(const Instant& now);

  /// What it answers if nobody can tell what holds: the robot stands.
  const Guarded& stand(const Instant& now, const Doubt& doubt);

  /// Goes on with other settings; throws like the constructor and then keeps the old ones.
  void adopt(const Settings& settings);

  void forget_losses() { perception_.forget_losses(); }

  /// As lines, for another process to recall: perception.hpp.
  std::vector<std::string> remembered() const { return perception_.remembered(); }
  bool recall(const std::vector<std::string>& remembered) { return perception_.recall(remembered); }

  /// [s] until the next sensor or switch counts as silent, or what is wanted does not hold any more; infinite if none
  /// will.
  double until_silent(double now) const;

  /// As settings.hpp has it.
  double answer_period() const { return answer_period_; }

  const Settings& settings() const { return settings_; }

 private:
  std::vector<Known> known_at(const Instant& now);
  UnderWay under_way(const Twist2& wanted, const Instant& now) const;
  Allowed overridden(const Twist2& wanted, const std::vector<Known>& known, const Instant& now) const;
  Allowed allowed_now(const Instant& now, const std::vector<Known>& known) const;
  const Guarded& settle(Allowed allowed, const Instant& now);

  struct Stop {
    double stamp, came;  ///< [s] of ROS time, and steady
  };

  Settings settings_;
  Guard guard_;
  Perception perception_;
  Given given_;
  double answer_period_;  ///< [s]
  std::optional<Command> wanted_;
  double wanted_at_ = 0.0;               ///< [s, steady]
  std::optional<Stop> stop_;             ///< if the latest that was obeyed is to stand
  std::optional<std::string> unwanted_;  ///< why what is wanted is not obeyed, by its stamp
  SightOverride override_;
  Guarded last_;
};

}  // namespace safety_control_cloud
