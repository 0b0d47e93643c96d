// SPDX-License-Identifier: BSD-3-Clause
#include "looks_taken.hpp"

#include <algorithm>
#include <utility>

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

Drift LooksTaken::take_placed(std::size_t sensor, const Whereabouts& robot, double now, std::optional<double> stamp,
                              double came_after) {
  add({sensor, now, now - came_after, robot, stamp});
  if (stamp && stamp_ && *stamp < *stamp_) return {};
  const Drift since = drift_from_latest_to(robot);
  robot_ = robot;
  stamp_ = stamp;
  return since;
}

void LooksTaken::add(Taken look) {
  latest_of_[look.sensor] = ++latest_;
  taken_.push_back(std::move(look));
}

/// Where the robot was at each look is not known any more.
void LooksTaken::go_on_in_frame(const Whereabouts& there) {
  robot_ = there;
  stamp_.reset();
  for (Taken& look : taken_) look = {look.sensor, look.at, look.taken_at, {there.pose, there.or_else}};
}

void LooksTaken::forget_before(double moment) {
  while (taken_.size() > 1 && taken_.front().at < moment) taken_.pop_front();
}

const LooksTaken::Taken* LooksTaken::find(std::uint64_t look) const {
  const std::uint64_t since = latest_ - look;
  return since < taken_.size() ? &taken_[taken_.size() - 1 - static_cast<std::size_t>(since)] : nullptr;
}

bool LooksTaken::is_latest_older_than(std::uint64_t look) const {
  const Taken* taken = find(look);
  return taken && look != latest_ && taken_.back().taken_at <= taken->taken_at;
}

bool LooksTaken::is_latest_of_its_sensor(std::uint64_t look) const {
  const Taken* taken = find(look);
  return taken && latest_of_.at(taken->sensor) == look;
}

std::optional<std::uint64_t> LooksTaken::placed_before_latest_of(std::size_t sensor) const {
  for (std::uint64_t before = latest_of_.at(sensor) - 1; const Taken* earlier = find(before); --before)
    if (earlier->sensor == sensor && earlier->stamp) return before;
  return std::nullopt;
}

double LooksTaken::period_of(std::size_t sensor) const {
  const Taken* latest = find(latest_of_.at(sensor));
  const auto before = placed_before_latest_of(sensor);
  return latest && before ? latest->at - find(*before)->at : 0.0;
}

WaySince::WaySince(const LooksTaken& looks, const Whereabouts& robot)
    : looks_(looks), robot_(robot), ways_(robot.or_else.empty() ? 0 : looks.size()) {}

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

}  // namespace safety_control_cloud
