// SPDX-License-Identifier: BSD-3-Clause
#include "odometry_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace safety_control_cloud {
namespace {

constexpr double gap = 0.2;            ///< [s] between two looks, of which one is to be a second ago
constexpr double most_off_pace = 0.2;  ///< of a second: by so much ROS time may differ from it

Compared compared_since(const Instant& then, const Odometry& odometry, const Given& given, const Instant& now) {
  const double late = std::max(0.0, now.ros - odometry.spoke_until());  // [s]
  const auto from = odometry.pose_at(then.ros - late), to = odometry.pose_at(now.ros - late);
  if (!from || !to) return {};
  const std::vector<Pose2> before = given.whereabouts_at(then.steady - late).or_else;
  const std::vector<Pose2> there = given.whereabouts_at(now.steady - late).or_else;
  std::vector<Pose2> ways;
  for (std::size_t i = 0; i < std::min(before.size(), there.size()); ++i) ways.push_back(between(before[i], there[i]));
  return compared(between(*from, *to), ways);
}

}  // namespace

void OdometryCheck::forget() {
  contradicted_.reset();
  all_ = {};
}

/// Who simulates slowly is told nothing of how long a command held.
bool OdometryCheck::note_look(const Odometry* odometry, const Given& given, const Instant& now) {
  while (!looked_.empty() && now.steady - looked_.front().steady > compared_over + gap) looked_.pop_front();
  looked_.push_back(now);
  const Instant& then = looked_.front();
  const double steady = now.steady - then.steady;
  const bool keeps_pace = std::abs(now.ros - then.ros - steady) <= most_off_pace * steady;
  if (!odometry || steady < compared_over || !keeps_pace) return false;
  const Compared latest = compared_since(then, *odometry, given, now);
  all_.note(latest, now.steady);
  if (latest.contradiction && all_.prevail()) contradict(*latest.contradiction, now.steady);
  return true;
}

bool OdometryCheck::note_jump(const Instant& now) {
  if (!all_.has_stood()) return false;
  contradict("it stood while the base was told to go, and then jumped", now.steady);
  return true;
}

/// What was misplaced before is so still.
void OdometryCheck::contradict(std::string how, double now) {
  contradicted_ = Contradicted{now, contradiction_at(now).has_value(), std::move(how)};
}

std::optional<std::string> OdometryCheck::contradiction_at(double now) const {
  const bool still = contradicted_ && contradicted_->misplaces && now - contradicted_->at <= time_;
  return still ? std::optional(contradicted_->how) : std::nullopt;
}

}  // namespace safety_control_cloud
