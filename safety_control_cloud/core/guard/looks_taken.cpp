// SPDX-License-Identifier: BSD-3-Clause
#include "looks_taken.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

constexpr double no_difference = 1e-6;  ///< [m], [rad]

/// None twice.
std::vector<Pose2> ways_between(const Whereabouts& then, const Whereabouts& now) {
  const Pose2 way = between(then.pose, now.pose);
  std::vector<Pose2> ways;
  for (std::size_t i = 0; i < std::min(then.or_else.size(), now.or_else.size()); ++i) {
    const Pose2 other = between(way, between(then.or_else[i], now.or_else[i]));
    const auto is_same = [&](const Pose2& one) { return displacement(between(one, other), 1.0) < no_difference; };
    if (std::none_of(ways.begin(), ways.end(), is_same)) ways.push_back(other);
  }
  return ways;
}

}  // namespace

void LooksTaken::take_placed(std::size_t sensor, const Whereabouts& robot, double now) {
  drift_ = drift_until(robot);
  robot_ = robot;
  add(sensor, robot, now);
}

Drift LooksTaken::drift_until(const Whereabouts& robot) const {
  if (!robot_) return drift_;
  const Pose2 way = between(robot_->pose, robot.pose);
  const Drift &before = robot_->unexplained, &now = robot.unexplained;
  return {drift_.place + robot.drift * length_of(way.place) + std::max(0.0, now.place - before.place),
          drift_.heading + robot.drift * std::abs(way.heading) + std::max(0.0, now.heading - before.heading)};
}

void LooksTaken::add(std::size_t sensor, const Whereabouts& robot, double now) {
  latest_of_[sensor] = ++latest_;
  taken_.push_back({sensor, now, robot, drift_});
}

/// What the way until now may be off by is for those to keep who know a place.
void LooksTaken::go_on_in_frame(const Whereabouts& there) {
  robot_ = there;
  for (Taken& look : taken_) look = {look.sensor, look.at, {there.pose, there.or_else}, drift_};
}

void LooksTaken::forget_before(double moment) {
  while (taken_.size() > 1 && taken_.front().at < moment) taken_.pop_front();
}

const LooksTaken::Taken* LooksTaken::find(std::uint64_t look) const {
  const std::uint64_t since = latest_ - look;
  return since < taken_.size() ? &taken_[taken_.size() - 1 - static_cast<std::size_t>(since)] : nullptr;
}

bool LooksTaken::is_latest_of_its_sensor(std::uint64_t look) const {
  const Taken* taken = find(look);
  return taken && latest_of_.at(taken->sensor) == look;
}

WaySince::WaySince(const LooksTaken& looks, const Whereabouts& robot)
    : looks_(looks), robot_(robot), drift_(looks.drift_until(robot)), ways_(robot.or_else.empty() ? 0 : looks.size()) {}

const std::vector<Pose2>& WaySince::or_else(std::uint64_t look) {
  static const std::vector<Pose2> none;
  const std::uint64_t since = looks_.latest() - look;
  if (since >= ways_.size()) return none;
  auto& ways = ways_[static_cast<std::size_t>(since)];
  if (!ways) ways = ways_between(looks_.find(look)->robot, robot_);
  return *ways;
}

double WaySince::beside(std::uint64_t look, double range) {
  double most = 0.0;
  for (const Pose2& way : or_else(look)) most = std::max(most, displacement(way, range));
  return most;
}

double WaySince::off(std::uint64_t look, double range) {
  const Drift& then = looks_.find(look)->drift;
  return drift_.place - then.place + (drift_.heading - then.heading) * range + beside(look, range);
}

}  // namespace safety_control_cloud
