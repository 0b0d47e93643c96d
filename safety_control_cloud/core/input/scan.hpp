// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cloud.hpp"

namespace safety_control_cloud {

/// One turn of a planar range finder, as sensor_msgs/LaserScan has it: bearings in the plane of x (forward) and y
/// (left), anticlockwise around z.
struct Scan {
  double angle_min = 0.0, angle_max = 0.0, angle_increment = 0.0;  ///< [rad]
  double time_increment = 0.0, scan_time = 0.0;                    ///< [s] between two beams, and between two turns
  double range_min = 0.0, range_max = 0.0;                         ///< [m]
  const float* ranges = nullptr;                                   ///< [m]
  std::size_t size = 0;
};

/// A scan as points of its own frame. By REP 117: a range within the limits is a return, -Inf is too close to measure,
/// NaN and what lies outside of the limits are no measurements, and +Inf met nothing within range_max. 0 is too close
/// where range_min is 0.
struct ScanView {
  CloudView points;                ///< of one row, a point a beam; +Inf is nothing measured
  std::size_t z_if_inf_is_free;    ///< [byte] in a point: z where +Inf has seen, far away, that nothing is there
  std::size_t z_if_zero_is_inf;    ///< [byte] where 0 says what +Inf says
  std::size_t z_if_both;           ///< [byte]
  double first = 0.0, last = 0.0;  ///< [rad] bearings, first <= last
  bool descending = false;         ///< the first point is that of the last bearing
  double range_min = 0.0;          ///< [m] nearer than which nothing is measured
  double range_max = 0.0;          ///< [m] beyond which nothing is
  double lasts = 0.0;              ///< [s] from the first beam, whose moment is the stamp, to the last
};

/// The points of scans, one after the other: what a view shows stays until the next.
class ScanPoints {
 public:
  /// Throws std::invalid_argument, in words for the robot's owner, if the scan contradicts itself.
  ScanView of(const Scan& scan);

 private:
  std::vector<std::array<float, 6>> points_;  ///< x, y, z, z_if_inf_is_free, z_if_zero_is_inf, z_if_both
};

}  // namespace safety_control_cloud
