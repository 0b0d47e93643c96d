// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "extremes.hpp"
#include "pose.hpp"
#include "whereabouts.hpp"

namespace safety_control_cloud {

/// What the base was told, and so what it may be doing and may have done, between obeying at once and as late and as
/// slowly as it can. Times are steady [s].
class Given {
 public:
  explicit Given(const Following& following) : following_(following) {}

  void follow(const Following& following) { following_ = following; }

  /// The base is told this from now on.
  void note(const Twist2& twist, double now);

  /// What it was told last then.
  Twist2 told_at(double moment) const;

  /// The most that it was told of late, so that it may do that still.
  Fastest fastest_of_late() const;

  /// All that it may be doing until a new command has its effect: every twist of the last delay, how it still moves if
  /// it brakes as slowly as it can, and what is `measured`; or fewer, if no stopping way of these exceeds theirs.
  std::vector<Twist2> under_way(double now, const std::optional<Twist2>& measured = std::nullopt) const;

  /// The factor of a twist that a base which brakes as slowly as it can is down to in `time` [s] after a command to
  /// stop has its effect; 0 if what it may be doing until then is not nearly on the path of that twist, or if it is not
  /// `measured` to be as slow as such a base by now: who lags brakes the less the less he is told to.
  double slowing_along(const Twist2& wanted, double now, double time, const std::optional<Twist2>& measured) const;

  /// Where the robot is, in a frame that rests, if it obeys at once, half of it, or as late as can be.
  using Reckoned = std::array<Pose2, 3>;

  /// At most ten seconds ago.
  Reckoned reckoned_at(double moment) const;

  /// Ways that it may have gone from there until now, however long ago that was: none, and those of who obeys so. The
  /// true one lies between them.
  std::vector<Pose2> ways_since(const Reckoned& then, double now) const;

  /// Where it is by all that it was told so far, however long that is, between those who obey at once, or as late and
  /// as slowly as can be, one command so and the next otherwise, or who stand when nobody tells them to go on. At most
  /// ten seconds ago.
  Whereabouts whereabouts_at(double moment) const;

 private:
  /// At that moment: what a base did and where it was that obeys as late as can be, gains speed at once and loses it as
  /// slowly as it can; where one was who obeys at once, or half of it; and all that one may have been.
  struct Told {
    double since;
    Twist2 twist;
    Twist2 slow;
    Pose2 slow_at, at_once, half;
    Extremes extremes;
  };

  std::deque<Told>::const_iterator first_after(double moment) const;
  Twist2 slowly_at(double moment) const;
  Pose2 slow_pose_at(double moment) const;
  TwistRange aims_at(double moment) const;
  Extremes extremes_at(double moment) const;
  template <class Then, class Go>
  Then gone_on(double moment, Then Told::*then, Go go) const;
  Pose2 at_once(double moment) const;
  Pose2 half(double moment) const;
  /// What comes to the same, until it stops, as one twist that is kept for the delay.
  struct Steady {
    Twist2 twist;
    Twist2 now;   ///< what the slowest base does at this moment
    Twist2 rest;  ///< by which any of them differs from a share of the same motion, at most

    Twist2 with(const Twist2& measured) const;
  };

  std::optional<Steady> as_if_steady(const std::vector<Twist2>& twists, double now) const;

  Following following_;
  std::deque<Told> told_;
};

}  // namespace safety_control_cloud
