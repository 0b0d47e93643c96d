// SPDX-License-Identifier: BSD-3-Clause
#include "odometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../input/angle.hpp"
#include "../text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double kept = 60.0;         ///< [s]
constexpr std::size_t most = 5000;    ///< of them, however often they come
constexpr std::size_t some = 10;      ///< of them tell how often they come
constexpr double longest_gap = 0.25;  ///< [s] over which a twist is taken to last
constexpr double most_off = 0.1;      ///< [m], [rad] by which a pose may miss what the twists before and after explain
constexpr double most_off_rate = 0.25;  ///< the same, as a share of what they explain
constexpr double noise = 0.01;          ///< [m], [rad] of a pose
constexpr double slew_over = 1.0;       ///< [s] over which what is less than noise from pose to pose adds up
constexpr double told_for = 1.0;        ///< [s] that a jump is told of

bool is_finite(const Pose2& pose) { return is_finite(pose.place) && std::isfinite(pose.heading); }

/// Of a speed, that is no more than the most.
double share_within(double most, double speed) { return speed > most ? most / speed : 1.0; }

Drift unexplained(const Pose2& from, const Pose2& to, const Drift& explained) {
  const Pose2 way = between(from, to);
  return {length_of(way.place) - explained.place, std::abs(wrapped(way.heading)) - explained.heading};
}

/// Whether it lies there, as far as twists explain the way.
bool is_reached(const Pose2& from, const Pose2& to, const Drift& explained) {
  const Drift off = unexplained(from, to, explained);
  return off.place <= most_off && off.heading <= most_off;
}

Drift beyond_noise(const Drift& off) {
  return {off.place > noise ? off.place : 0.0, off.heading > noise ? off.heading : 0.0};
}

}  // namespace

void Odometry::note(double stamp, const Pose2& pose, const Twist2& twist, const Fastest& fastest) {
  Noted next{stamp, pose, twist, fastest};
  if (!std::isfinite(stamp) || !is_finite(pose) || !is_sound(twist)) {
    if (!noted_.empty()) ++jumps_;  // for all that is known
    forget();
    return;
  }
  if (is_known(next)) return;
  tells_twists_ = tells_twists_ || speed_of(twist) > 0.0 || twist.w != 0.0;
  const Drift explained = explained_until(next);
  if (!noted_.empty() && !goes_on(next, explained)) {
    if (!is_reached(noted_.back().pose, pose, {})) ++jumps_;
    forget();
  }
  if (noted_.empty()) {
    since_ = stamp;
    anchor_ = {stamp, pose};
  } else {  // headings go on beyond a full turn, so that the way between two poses is the short one
    const double before = noted_.back().pose.heading;
    next.pose.heading = before + wrapped(pose.heading - before);
    count_unexplained(next, explained);
  }
  noted_.push_back(next);
  while (noted_.size() > most || noted_.front().stamp < stamp - kept) noted_.pop_front();
}

void Odometry::note_pose(double stamp, const Pose2& pose, const Fastest& fastest) {
  const double time = noted_.empty() ? 0.0 : stamp - noted_.back().stamp;
  if (!(time > 0.0)) return note(stamp, pose, {}, fastest);
  const Pose2 way = between(noted_.back().pose, pose);
  const double per_second = 1.0 / time, turn = wrapped(way.heading);
  const Twist2 twist{way.place.x * per_second, way.place.y * per_second, turn * per_second};
  const double share =
      std::min(share_within(fastest.speed, speed_of(twist)), share_within(fastest.turning, std::abs(twist.w)));
  note(stamp, pose, limited(twist, share), fastest);
}

void Odometry::forget() {
  if (!noted_.empty()) ++breaks_;
  noted_.clear();
  tells_twists_ = false;  // it may be another's by now
  since_ = std::numeric_limits<double>::infinity();
}

/// From the latest on, so far at most. Of who tells no twists, one that goes on as before is explained.
Drift Odometry::explained_until(const Noted& next) const {
  if (noted_.empty()) return {};
  const Noted& last = noted_.back();
  double speed = std::max(speed_of(last.twist), speed_of(next.twist));
  double turning = std::max(std::abs(last.twist.w), std::abs(next.twist.w));
  if (!tells_twists_ && noted_.size() > 1) {
    const Noted& before = noted_[noted_.size() - 2];
    const Pose2 latest = between(before.pose, last.pose);
    speed = std::max(speed, std::min(next.fastest.speed, length_of(latest.place) / (last.stamp - before.stamp)));
    turning = std::max(turning, std::min(next.fastest.turning, std::abs(latest.heading) / (last.stamp - before.stamp)));
  }
  const double explained = (1.0 + most_off_rate) * (next.stamp - last.stamp);
  return {explained * speed, explained * turning};
}

/// At once, or over all of the time since the anchor: a pose that slews slowly, as one that is corrected by and by, is
/// as wrong as one that jumps as far.
void Odometry::count_unexplained(Noted& next, const Drift& explained) {
  const Noted& last = noted_.back();
  anchor_.explained = anchor_.explained + explained;
  const Drift at_once = last.unexplained + beyond_noise(unexplained(last.pose, next.pose, explained));
  const Drift in_all = anchor_.unexplained + beyond_noise(unexplained(anchor_.pose, next.pose, anchor_.explained));
  next.unexplained = {std::max(at_once.place, in_all.place), std::max(at_once.heading, in_all.heading)};
  if (next.stamp - anchor_.stamp >= slew_over) anchor_ = {next.stamp, next.pose, {}, next.unexplained};
}

/// A relay or a driver of two threads says some things twice, and some in another order.
bool Odometry::is_known(const Noted& said) const {
  if (noted_.empty()) return false;
  const double latest = noted_.back().stamp;
  if (said.stamp > latest || said.stamp < std::max(noted_.front().stamp, latest - longest_gap)) return false;
  const Pose2 off = between(interpolated(said.stamp), said.pose);
  return length_of(off.place) <= noise && std::abs(wrapped(off.heading)) <= noise;
}

/// [s] from the latest stamp. Who did not listen goes on with where the robot is by now, as far as its twists explain
/// that.
double Odometry::longest_gap_until(double stamp) const {
  if (!deaf_) return longest_gap;
  return longest_gap + std::max(0.0, std::min(stamp, deaf_->until) - std::max(noted_.back().stamp, deaf_->from));
}

bool Odometry::goes_on(const Noted& next, const Drift& explained) const {
  const double time = next.stamp - noted_.back().stamp;
  return time > 0.0 && time <= longest_gap_until(next.stamp) && is_reached(noted_.back().pose, next.pose, explained);
}

Drift Odometry::unexplained_until(double stamp) const {
  if (noted_.empty()) return {};
  const auto after = std::upper_bound(noted_.begin(), noted_.end(), stamp,
                                      [](double moment, const Noted& noted) { return moment < noted.stamp; });
  return after == noted_.begin() ? after->unexplained : std::prev(after)->unexplained;
}

bool Odometry::is_fresh(double now) const {
  return !noted_.empty() && std::abs(now - noted_.back().stamp) <= longest_gap;
}

bool Odometry::stays_fresh(double now) const {
  const std::size_t latest = std::min(noted_.size(), some);
  if (latest < 2) return is_fresh(now);
  const double time = noted_.back().stamp - noted_[noted_.size() - latest].stamp;
  return is_fresh(now) && is_fresh(now + time / static_cast<double>(latest - 1));
}

std::optional<std::string> Odometry::doubt_at(double now) const {
  if (noted_.empty()) return breaks_ > 0 ? std::optional<std::string>("it told what no robot does") : std::nullopt;
  if (is_fresh(now)) {
    if (breaks_ == 0 || now - since_ > told_for) return std::nullopt;
    return words("it did not go on from what it had told, for the ", breaks_, ". time");
  }
  const double age = now - noted_.back().stamp;
  return "its latest stamp is " + measured(std::abs(age), "s") + (age > 0.0 ? " old" : " ahead");
}

std::optional<Pose2> Odometry::way_since(double stamp, double now) const {
  if (!is_fresh(now) || !(stamp >= noted_.front().stamp)) return std::nullopt;
  return between(interpolated(stamp), interpolated(std::max(stamp, now)));
}

std::optional<Pose2> Odometry::pose_at(double stamp) const {
  if (noted_.empty() || !(stamp >= noted_.front().stamp && stamp <= noted_.back().stamp + longest_gap))
    return std::nullopt;
  return interpolated(stamp);
}

std::optional<Twist2> Odometry::twist_at(double now) const {
  return is_fresh(now) ? std::optional(noted_.back().twist) : std::nullopt;
}

/// Of who tells no twists, the one that led to the latest pose.
Pose2 Odometry::foretold(double time) const {
  const Noted& last = noted_.back();
  if (tells_twists_ || noted_.size() < 2) return beyond(last.pose, way_of(last.twist, time));
  const Noted& before = noted_[noted_.size() - 2];
  return beyond(last.pose, shared(between(before.pose, last.pose), time / (last.stamp - before.stamp)));
}

/// By the twist of the pose before.
Pose2 Odometry::interpolated(double stamp) const {
  const auto after = std::upper_bound(noted_.begin(), noted_.end(), stamp,
                                      [](double moment, const Noted& noted) { return moment < noted.stamp; });
  const Noted& before = after == noted_.begin() ? *after : *std::prev(after);
  if (after == noted_.end()) return foretold(stamp - before.stamp);
  if (after == noted_.begin()) return beyond(before.pose, way_of(before.twist, stamp - before.stamp));
  const double share = (stamp - before.stamp) / (after->stamp - before.stamp);
  return beyond(before.pose, shared(between(before.pose, after->pose), share));
}

}  // namespace safety_control_cloud
