// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "../input/scan.hpp"
#include "../look/field_of_view.hpp"
#include "../path/outline.hpp"
#include "eye.hpp"

namespace safety_control_cloud {

/// Which heights count.
struct Heights {
  double bottom, top;  ///< [m] over base_frame, inclusive
};

/// How far along the ground a sensor sees what stands there: a laser as far as it measures and its plane lies between
/// the heights that count, a camera as long as one of its rows does. What does not return from farther away says
/// nothing.
class Horizon {
 public:
  /// None: it sees without end.
  Horizon() = default;
  Horizon(const Outlook& outlook, const ScanView& scan, const Heights& heights);
  Horizon(const Outlook& outlook, const FieldOfView& field, const Heights& heights);

  /// [m] from the sensor in a direction of length 1 or 0.
  double towards(const Point2& direction) const;
  /// [m] in no direction less.
  double least() const;

 private:
  double at_slopes(double low, double high) const;

  double range_ = std::numeric_limits<double>::infinity();  ///< [m]
  double above_ = 0.0, below_ = 0.0;  ///< [m] from the sensor up to the greatest height that counts, down to the least
  Point2 gradient_;                   ///< of a plane in which it looks
  double low_ = 0.0, high_ = 0.0;     ///< slopes of its lowest and highest ray on top of that
};

/// A sensor's eye and how far it saw when it looked.
struct Sighted {
  Eye eye;
  Horizon horizon;
  double nearer = 0.0;  ///< [m] by which what lies beyond may be nearer by the time that the robot stands
};

/// [s] of a twist after which the footprint, widened by its margin, comes to where one of them looks and none that does
/// sees so far; infinite if it does not within `until` [s].
double time_to_horizon(const Outline& outline, const std::vector<Sighted>& sensors, const Twist2& twist, double until);

}  // namespace safety_control_cloud
