// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include "guard/given.hpp"
#include "guard/guard.hpp"
#include "guard/kept_places.hpp"
#include "guard/odometry.hpp"
#include "guard/out_of_sight.hpp"
#include "guard_sensor.hpp"
#include "odometry_check.hpp"
#include "settings.hpp"

namespace safety_control_cloud {

/// What is known of where the robot went. Borrowed for the length of a call.
struct Went {
  const Odometry& odometry;
  const Given& given;
};

/// What no sensor shows any more, placed by odometry where that goes on, or else by what the base was told; and what
/// speaks against it.
class GuardMemory {
 public:
  /// The settings are fit.
  explicit GuardMemory(const Settings& settings);

  /// Goes on with other settings.
  void adopt(const Settings& settings);

  /// Nothing is remembered, and nothing speaks against that.
  void forget();

  /// What is placed by odometry, or was until that broke off, for another process to go on with, or that nobody knows
  /// where it is; empty if nothing is.
  std::string remembered() const;

  /// Goes on with that once odometry does from where it was; false, and nothing changes, if it is not legible. Until
  /// then nobody knows where what it tells of is.
  bool recall(const std::string& remembered);

  /// Whether odometry did not go on since this was asked last, so that where the robot was by it is not known any more.
  /// What is remembered goes on from the latest look, by what the base was told since.
  bool note_breaks(const Went& went, const Instant& now);

  /// Nobody listened for so long [s] until now, as the robot did what it was `given`, or stood, since that ended.
  void note_deafness(double seconds, const Given& given, const Instant& now);

  /// A sensor shows this. Where the robot was then by odometry; none: nobody knows.
  std::optional<Pose2> note(std::size_t sensor, const Look& look, const Went& went, const Instant& now);

  /// Whether anything would be kept.
  bool remembers() const { return out_of_sight_.remembers(); }

  /// Where the robot was at a stamp [s, ROS], by odometry; none: nobody knows.
  std::optional<Whereabouts> by_odometry_at(double stamp, const Went& went, const Instant& now) const;

  /// What was seen to rest, as the sensor has it that showed this; nothing, if nobody knows where the robot was.
  std::vector<KnownPlace> resting(const Look& look, const Went& went, const Instant& now) const;

  /// The same of a sensor that looks from there.
  std::vector<KnownPlace> resting(const Outlook& sensor, const Whereabouts& robot, const Instant& now) const;

  /// `shows`: of each sensor, whether its latest look is believed still. Holds until it is asked again.
  std::vector<Known> known_at(const Instant& now, const Went& went, const std::vector<GuardSensor>& sensors,
                              const std::vector<bool>& shows, const Guard& guard);

 private:
  /// By the settings.
  struct Limits {
    explicit Limits(const Settings& settings);
    OutOfSightLimits places;
    Sensors sensors;
    double odometry_drift;  ///< [m/m], [rad/rad]
    double margin;          ///< [m]
    Twist2 fastest;         ///< of the robot
  };

  /// Of which of the places somebody asks.
  struct Around {
    Whereabouts robot;
    double reach;  ///< [m]
    double now;    ///< [s, steady]
  };

  void place_recalled(double stamp, const Whereabouts& robot, const Went& went, const Instant& now);
  static double looks_since(const Went& went, const Instant& now);
  void go_on_as_told(const Instant& now);
  bool is_mistaken(const Instant& now) const;
  void choose_whereabouts(double stamp, const Went& went, const Instant& now);
  static Drift foretold_at(double stamp, const Went& went, const Instant& now);
  Pose2 way_during(const Look& look, const Went& went, const Instant& now) const;
  std::optional<Whereabouts> whereabouts_at(double age, const Went& went, const Instant& now) const;
  std::optional<KeptPlaces> to_keep() const;
  bool waits_for(const std::vector<GuardSensor>& sensors, const Instant& now) const;
  bool has_strayed(const Instant& now) const;
  std::vector<Known> placed_by_odometry(const Known& like, const Around& around, const std::vector<bool>& shows);
  std::vector<Known> placed_as_told(Known like, const Around& around, const std::vector<GuardSensor>& sensors,
                                    const std::vector<bool>& shows);
  Known at_large(Known like, const Around& around, const std::vector<GuardSensor>& sensors,
                 const std::vector<bool>& shows);
  Known with(std::vector<Ring> rings, Known like);
  std::optional<Doubt> doubt_at(const Instant& now, const Went& went, const std::vector<GuardSensor>& sensors) const;

  struct Latest {
    double stamp, at;     ///< [s] ROS, steady
    Whereabouts robot;    ///< then, in the frame of the places
    Whereabouts as_told;  ///< the same by what the base was told
  };

  Limits limits_;
  OutOfSight out_of_sight_;
  OdometryCheck check_;
  std::list<std::vector<Ring>> rings_;   ///< as they were asked for last: of all sensors, or of each
  bool by_odometry_ = false;             ///< it is known where that is; or else by what the base was told
  std::size_t breaks_ = 0, jumps_ = 0;   ///< of the odometry, after which that began
  std::optional<KeptPlaces> recalled_;   ///< of another process, and not placed yet
  std::optional<KeptPlaces> broke_off_;  ///< as odometry had them placed that has not placed any since
  std::optional<Latest> latest_;         ///< look that was placed
  std::optional<double> told_since_;     ///< [s, steady] odometry broke off, and has not spoken since
  std::optional<double> strayed_;        ///< [s, steady] it went on by itself until then, as far as nobody knows
  std::optional<double> mistaken_;       ///< [s, ROS] nobody knew then where what was near is, nor for how long before
  std::optional<double> jumped_;         ///< [s, ROS] since then odometry goes on, and not every sensor has looked
};

}  // namespace safety_control_cloud
