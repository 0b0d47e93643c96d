// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "pose.hpp"

namespace safety_control_cloud {

/// How a base follows what it is told, at its slowest.
struct Following {
  double delay;                 ///< [s] from a command to its effect
  double linear_deceleration;   ///< [m/s2]
  double angular_deceleration;  ///< [rad/s2]
};

/// What the base was told, and so what it may be doing and may have done, between obeying at once and as late and as
/// slowly as it can. Times are steady [s].
class Given {
 public:
  explicit Given(const Following& following) : following_(following) {}

  void follow(const Following& following) { following_ = following; }

  /// The base is told this from now on.
  void note(const Twist2& twist, double now);

  /// All that it may be doing until a new command has its effect: every twist of the last delay, how it still moves if
  /// it brakes as slowly as it can, and what is `measured`; or fewer, if no stopping way of these exceeds theirs.
  std::vector<Twist2> under_way(double now, const std::optional<Twist2>& measured = std::nullopt) const;

  /// Where the robot is, in a frame that rests, if it obeys at once, half of it, or as late as can be.
  using Reckoned = std::array<Pose2, 3>;

  /// At most ten seconds ago.
  Reckoned reckoned_at(double moment) const;

  /// Ways that it may have gone from there until now, however long ago that was: none, and those of who obeys so. The
  /// true one lies between them.
  std::vector<Pose2> ways_since(const Reckoned& then, double now) const;

 private:
  struct Told {
    double since;
    Twist2 twist;
    Twist2 slowly;  ///< what the slowest base did at that moment
    Reckoned at;
  };

  std::deque<Told>::const_iterator first_after(double moment) const;
  Twist2 told_at(double moment) const;
  Twist2 slowly_at(double moment) const;
  /// What comes to the same, until it stops, as one twist that is kept for the delay.
  struct Steady {
    Twist2 twist;
    Twist2 now;   ///< what the slowest base does at this moment
    Twist2 rest;  ///< by which any of them differs from a share of the same motion, at most

    Twist2 with(const Twist2& measured) const;
  };

  std::optional<Steady> as_if_steady(const std::vector<Twist2>& twists, double now) const;
  Pose2 slow_way(double then, double now) const;

  Following following_;
  std::deque<Told> told_;
};

}  // namespace safety_control_cloud
