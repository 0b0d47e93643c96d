// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "pose.hpp"
#include "whereabouts.hpp"

namespace safety_control_cloud {

/// What the base says of where it went. It is believed as long as it goes on without a gap, a jump or a number that is
/// none; what is older than the latest of these is not known. What comes twice, or late by less than a gap, is passed
/// over if it is where the robot is known to have been.
class Odometry {
 public:
  /// The robot was at this pose of a frame that rests, and had this twist, at `stamp` [s, ROS time]. Of who leaves the
  /// twists zero, what goes on as before is explained, up to `fastest`.
  void note(double stamp, const Pose2& pose, const Twist2& twist, const Fastest& fastest = {});

  /// The same of whom tells poses alone: its twist is what leads there from the pose before, up to `fastest`. What is
  /// faster no twist explains.
  void note_pose(double stamp, const Pose2& pose, const Fastest& fastest);

  /// Nobody listened from then until then [s, ROS time]: what was said meanwhile is not known, but that it was.
  void note_deafness(double from, double until) { deaf_ = Deaf{from, until}; }

  /// The way from `stamp` until `now` [s, ROS time]; none if it does not span that.
  std::optional<Pose2> way_since(double stamp, double now) const;

  /// The pose at `stamp` [s, ROS time], at most a gap after the latest; none if that is not known.
  std::optional<Pose2> pose_at(double stamp) const;

  /// The latest stamp [s, ROS time]; beyond that a pose is foretold. It has spoken.
  double spoke_until() const { return noted_.back().stamp; }

  /// What no twist explains of the way until `stamp` [s, ROS time], since it goes on: too little for a jump, which may
  /// come again, or so little from one pose to the next that it is told from noise over a second alone.
  Drift unexplained_until(double stamp) const;

  /// Whether it speaks at `now` [s, ROS time].
  bool is_fresh(double now) const;

  /// Whether it will until it is heard again, as often as it is.
  bool stays_fresh(double now) const;

  /// Why one who has spoken is not believed at `now` [s, ROS time].
  std::optional<std::string> doubt_at(double now) const;

  /// How often it did not go on from what was before, and the first stamp [s] since; infinite until then.
  std::size_t breaks() const { return breaks_; }
  /// How many of these were no pauses, after which it told of the same place as before.
  std::size_t jumps() const { return jumps_; }
  double goes_on_since() const { return since_; }

  /// [s] from that stamp to the latest.
  double goes_on_for() const { return noted_.empty() ? 0.0 : noted_.back().stamp - since_; }

  /// The twist of now; none if nothing was said lately.
  std::optional<Twist2> twist_at(double now) const;

 private:
  struct Noted {
    double stamp;
    Pose2 pose;
    Twist2 twist;
    Fastest fastest;         ///< of who tells no twists
    Drift unexplained = {};  ///< of all the way until there
  };

  /// A pose of late, and the way since as far as twists explain it.
  struct Anchor {
    double stamp = 0.0;
    Pose2 pose = {};
    Drift explained = {};    ///< at most
    Drift unexplained = {};  ///< of all the way until there
  };

  struct Deaf {
    double from, until;  ///< [s, ROS time]
  };

  double longest_gap_until(double stamp) const;
  Drift explained_until(const Noted& next) const;
  void count_unexplained(Noted& next, const Drift& explained);
  bool goes_on(const Noted& next, const Drift& explained) const;
  bool is_known(const Noted& said) const;
  void forget();
  Pose2 interpolated(double stamp) const;
  Pose2 foretold(double time) const;

  std::deque<Noted> noted_;
  std::optional<Deaf> deaf_;  ///< the latest
  std::size_t breaks_ = 0;
  std::size_t jumps_ = 0;
  double since_ = 0.0;
  bool tells_twists_ = false;  ///< some leave them zero for ever
  Anchor anchor_;
};

}  // namespace safety_control_cloud
