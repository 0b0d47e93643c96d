// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "doubt.hpp"
#include "settings.hpp"

namespace safety_control_cloud {

/// Follows how old clouds are when they come.
///
/// A cloud's age is what passed since it was taken, and by how much the camera's clock is off from ours. The least age
/// is the steady offset of both; what a cloud is older by was spent in a queue, and beyond source_timeout it is no
/// reason to drive. Nor is one that is younger by as much: its stamp is wrong, until all have been for a second. Clocks
/// drift: the offset falls at once, but rises no faster than a clock may drift, and a cloud of another age than the
/// drift explains must lie within stamp_tolerance. So a clock that drifts away over hours is followed, up to a minute;
/// an age that jumps, or grows faster than any clock drifts, is not.
class StampWatch {
 public:
  /// A cloud of this `age` [s, ROS time] has come at `now` [s, steady]: a doubt if its stamp cannot be believed. A
  /// stamp_tolerance of 0 believes any.
  std::optional<Doubt> note(double age, double now, const DoubtSettings& by);

  /// The offset is learned anew from the next cloud: somebody has looked, or a clock was set.
  void forget() {
    steady_.reset();
    early_since_.reset();
    believed_ = 0;
  }

 private:
  struct Spell {
    double since, age;  ///< [s] of its first cloud
  };

  bool is_early(double age, double now, double timeout);
  void start_from(double age);
  Doubt unexplained(double age, double now, double tolerance);
  void believe(double steady, double slack);

  std::optional<double> steady_;  ///< [s] the least age lately
  double drift_ = 0.0;            ///< [s] by which the clocks have drifted apart, as far as that was seen to happen
  unsigned believed_ = 0;         ///< clouds since the least age was learned anew
  std::optional<double> early_since_{};  ///< [s] steady: when clouds began to come earlier than any could
  std::optional<double> last_;           ///< [s] steady: of the latest cloud
  std::optional<Spell> spell_;           ///< of clouds that cannot be explained
};

}  // namespace safety_control_cloud
