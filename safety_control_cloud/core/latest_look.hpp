// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "guard/eye.hpp"
#include "guard/given.hpp"
#include "guard/horizon.hpp"
#include "guard/odometry.hpp"
#include "sensor.hpp"

namespace safety_control_cloud {

/// The latest reading of a guard's sensor that was believed: how old it is, and what lay within its sight.
struct LatestLook {
  bool is_scan;       ///< of a range finder
  FieldOfView field;  ///< of a camera
  Eye eye;
  Horizon horizon;
  Outlook outlook;         ///< of an upright camera
  double range_min = 0.0;  ///< [m] of a range finder, or else 0
  double lasts = 0.0;      ///< [s] for which it was being taken after its stamp
  Instant arrival{};
  double time_to_arrive = 0.0;  ///< [s] since its stamp, as far as that is believed
  Given::Reckoned from{};       ///< where the robot was then

  /// Of an upright view, in the band of these heights; of a range finder that has measured at these `bearings` lately.
  LatestLook(const Reading& reading, const View& view, const Outlook& outlook, const Heights& heights,
             const Bearings& bearings);

  /// [s, ROS] When it was taken, as far as its stamp is believed.
  double stamp() const { return arrival.ros - time_to_arrive; }

  /// [s] after its stamp within which each of its returns was measured: a stamp that is old may as well be off.
  double may_last() const;

  /// [s] since it was taken.
  double age_at(const Instant& now) const;

  /// Where the robot may have gone since, by odometry if that spans the time. Where the stamp may be off, also as if it
  /// had been taken when it came; of what was being taken for a while, also as if at the end of that.
  std::vector<Pose2> ways_since(const Instant& now, const Odometry& odometry, const Given& given) const;

  /// Whether the sensor looks toward a place in base_frame and cannot show what is there: it stands between these
  /// heights all below a camera's picture, or all above, or maybe nearer than a range finder measures, if it lies up to
  /// `off` [m] elsewhere.
  bool misses(const Point2& place, const Heights& heights, double off) const;
};

}  // namespace safety_control_cloud
