// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "guard/given.hpp"
#include "guard/guard.hpp"
#include "guard/odometry.hpp"
#include "guard/override.hpp"
#include "sensor.hpp"
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
  bool stuck = false;        ///< something is wanted and nothing is given
  double stuck_since = 0.0;  ///< [s, steady] if it is
  std::uint8_t open = 0;     ///< while it is: bits of the directions in which it may move (guard/directions.hpp)
  double override_left = 0.0;  ///< [s] for which what is seen is not asked; 0: it is
  Sight sight;               ///< what the latest reading held
};

/// The guard: what sensors see, what the base is told and does, what somebody wants; and of that, what is safe. Needs
/// no ROS and no clock: the time is an argument.
class GuardControl {
 public:
  /// Throws std::invalid_argument with all problems_in(settings), if there are any.
  explicit GuardControl(const Settings& settings);

  /// A reading has come, readable or not.
  void see(const Reading& reading, const Origin& origin, const Instant& now, Crop crop = Crop::Skip);

  /// Somebody wants this; `stamp` [s, ROS]: of a command that has one.
  void want(const Command& wanted, const Instant& now, std::optional<double> stamp = std::nullopt);

  /// The base says where it is.
  void note_odometry(double stamp, const Pose2& pose, const Twist2& twist) { odometry_.note(stamp, pose, twist); }

  /// What is in doubt outside of the sensors. From the next answer on the robot stands for it, until there is none.
  void note_outside(std::optional<Doubt> doubt) { outside_ = std::move(doubt); }

  /// Somebody asks that for a while nobody asks what is seen.
  OverrideReply ask_override(const OverrideWish& wish, const Instant& now);

  /// What holds now. It is taken for said: the robot is held to do it from now on.
  const Guarded& answer(const Instant& now);

  /// Goes on with other settings; throws like the constructor and then keeps the old ones.
  void adopt(const Settings& settings);

  void forget_losses() { sensor_.forget_losses(); }
  std::vector<std::string> remembered() const { return {sensor_.remembered()}; }

  /// Goes on with what another process remembered; false if it is not legible.
  bool recall(const std::vector<std::string>& remembered);


  const Settings& settings() const { return settings_; }

 private:
  /// Of the latest reading that was believed.
  struct Taken {
    Instant arrival;
    double time_to_arrive;  ///< [s] since its stamp, as far as that is believed
    Eye eye;
  };

  void take(const Reading& reading, const Origin& origin, const Instant& now);
  Known known_at(const Instant& now) const;
  std::vector<Pose2> ways_since_look(const Instant& now) const;
  std::vector<Twist2> under_way(const Instant& now) const;
  Allowed overridden(const Twist2& wanted, const Known& sensor, const Instant& now) const;
  Allowed allowed_now(const Instant& now, const std::vector<Known>& known) const;
  std::uint8_t open_directions(const Instant& now, const std::vector<Known>& known) const;

  Settings settings_;
  Guard guard_;
  Sensor sensor_;
  Surroundings around_;
  Odometry odometry_;
  Given given_;
  std::optional<Taken> taken_;
  bool was_sound_ = false;  ///< nothing but what it cannot see any more speaks against the sensor
  std::optional<Command> wanted_;
  double wanted_at_ = 0.0;  ///< [s, steady]
  std::optional<std::string> unwanted_;  ///< why what is wanted is not obeyed, by its stamp
  std::optional<Doubt> outside_;
  SightOverride override_;
  Guarded last_;
};

}  // namespace safety_control_cloud
