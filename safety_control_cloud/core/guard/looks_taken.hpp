// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "pose.hpp"
#include "whereabouts.hpp"

namespace safety_control_cloud {

/// The looks of all sensors, numbered as they came, and where the robot was at each.
class LooksTaken {
 public:
  struct Taken {
    std::size_t sensor;
    double at;                         ///< [s] steady, when it came
    double taken_at;                   ///< [s] steady
    Whereabouts robot;                 ///< in a frame that rests
    std::optional<double> stamp = {};  ///< [s] ROS, at which the robot was just there; none: it is there by now
  };

  /// A sensor looks, and nobody knows from where.
  void take(std::size_t sensor, double now) { add({sensor, now, now, Whereabouts{}}); }

  /// It looks, the robot being there. `stamp` [s] ROS; none: it is no look of this process.
  /// `came_after` [s] that. By how much the way there may be off, since the latest that was placed; nothing, if that
  /// has a later stamp.
  Drift take_placed(std::size_t sensor, const Whereabouts& robot, double now, std::optional<double> stamp = {},
                    double came_after = 0.0);

  /// From now on another frame rests, in which the robot is `there`.
  void go_on_in_frame(const Whereabouts& there);

  /// Those before `moment` [s, steady] are of no interest any more, but for the latest.
  void forget_before(double moment);

  /// The number of the latest look of all; 0 before the first.
  std::uint64_t latest() const { return latest_; }

  /// How many are not forgotten: the latest.
  std::size_t size() const { return taken_.size(); }

  /// [s] between the latest two looks of a sensor that were placed by a stamp; 0 if they are forgotten.
  double period_of(std::size_t sensor) const;

  /// Of how many sensors.
  std::size_t sensors() const { return latest_of_.size(); }

  /// None: it is forgotten.
  const Taken* find(std::uint64_t look) const;

  /// Of the way between there and where the robot was at the latest that was placed.
  Drift drift_from_latest_to(const Whereabouts& robot) const {
    return robot_ ? drift_between(*robot_, robot) : Drift{};
  }

  /// Whether the latest look of all was taken before this one, or at once with it: it came later.
  bool is_latest_older_than(std::uint64_t look) const;

  /// Whether no later look of the same sensor has been taken.
  bool is_latest_of_its_sensor(std::uint64_t look) const;

  /// The one before that, of those that were placed by a stamp; none: they are forgotten.
  std::optional<std::uint64_t> placed_before_latest_of(std::size_t sensor) const;

 private:
  void add(Taken look);

  std::deque<Taken> taken_;  ///< the latest of them
  std::uint64_t latest_ = 0;
  std::map<std::size_t, std::uint64_t> latest_of_;  ///< of each sensor
  std::optional<Whereabouts> robot_;                ///< at the latest that was placed, by its stamp
  std::optional<double> stamp_;                     ///< [s] ROS, of that
};

/// Where the robot may be instead, on the way from each look to where it is now. Borrows both.
class WaySince {
 public:
  WaySince(const LooksTaken& looks, const Whereabouts& robot);

  /// Where the robot may be now instead, as seen from where it is taken to be, if a place is where this look had it.
  const std::vector<Pose2>& or_else(std::uint64_t look);

  /// [m] that a place at this range lies elsewhere by these, at most.
  double beside(std::uint64_t look, double range);

 private:
  const LooksTaken& looks_;
  const Whereabouts& robot_;
  std::vector<std::optional<std::vector<Pose2>>> ways_;
};

}  // namespace safety_control_cloud
