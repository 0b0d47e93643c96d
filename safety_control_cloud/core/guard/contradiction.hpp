// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pose.hpp"

namespace safety_control_cloud {

/// [s] that is long enough to compare ways over, and short enough for a turn not to lead back.
constexpr double compared_over = 1.0;

/// A way by odometry, beside what the base was told.
struct Compared {
  bool agrees = false;                       ///< it went or turned as the base did for sure, if that obeyed
  std::optional<std::string> contradiction;  ///< in words, how it went or turned the other way
  bool stood = false;                        ///< it did neither, and the base for sure, if that obeyed
};

/// `way` is odometry's, `as_told` are those between which the base went if it did as it was told. To rest is neither,
/// nor is to go on without the turn: somebody may have pressed a stop button, a base may not turn as slowly, or be kept
/// from it.
Compared compared(const Pose2& way, const std::vector<Pose2>& as_told);

/// Whether odometry is wrong, and not the robot pushed, rolling back, or slow to turn about: of the time of late in
/// which both can be compared, in most of it odometry contradicts. Times are steady [s].
class Contradictions {
 public:
  void note(const Compared& one, double now);
  bool prevail() const;
  /// Whether it has stood since it agreed last, though the base was told to go. Nothing is wrong with that, until it
  /// jumps.
  bool has_stood() const;

 private:
  double against_ = 0.0, along_ = 0.0;  ///< [s], the longer ago the less
  double stood_ = 0.0;                  ///< [s]
  std::optional<double> noted_;
};

}  // namespace safety_control_cloud
