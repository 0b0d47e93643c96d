// SPDX-License-Identifier: BSD-3-Clause
#include "given.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "command.hpp"

namespace safety_control_cloud {
namespace {

constexpr double kept = 12.0;           ///< [s], more than source_timeout may be; and what was told last before that
constexpr double step = 0.02;           ///< [s] in which a way is gone
constexpr double longest_way = 2.0;     ///< [s] in more steps; longer ones in as many longer steps
constexpr double no_difference = 1e-6;  ///< [m], [rad]
constexpr double rounding = 1e-9;       ///< [s], [m/s], [rad/s]
constexpr double timeout = 0.5;         ///< [s] after which a base may stop that is told nothing
constexpr double of_late = 3.0;         ///< [s] in which any base comes to rest
constexpr double slip = 0.1;            ///< [m/m], [rad/rad] by which wheels may miss what they are told

double toward(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

double steps_in(double time) { return std::ceil(std::min(time, longest_way) / step); }

/// A base may gain speed at any rate, but loses it no slower than at this one.
double slowed(double from, double to, double most) {
  const bool gains = from * to >= 0.0 && std::abs(to) >= std::abs(from);
  return gains ? to : toward(from, to, most);
}

}  // namespace

void Given::note(const Twist2& twist, double now) {
  if (!told_.empty() && same(told_.back().twist, twist) && now - told_.back().since < following_.delay) return;
  told_.push_back({now, twist, slowly_at(now), slow_pose_at(now), at_once(now), half(now), extremes_at(now)});
  while (told_.size() > 1 && told_[1].since < now - kept) told_.pop_front();
}

std::deque<Given::Told>::const_iterator Given::first_after(double moment) const {
  return std::upper_bound(told_.begin(), told_.end(), moment,
                          [](double time, const Told& told) { return time < told.since; });
}

Twist2 Given::told_at(double moment) const {
  const auto after = first_after(moment);
  return after == told_.begin() ? Twist2{} : std::prev(after)->twist;
}

Fastest Given::fastest_of_late() const {
  Fastest fastest{0.0, 0.0};
  for (auto told = told_.rbegin(); told != told_.rend(); ++told) {
    fastest = {std::max(fastest.speed, speed_of(told->twist)), std::max(fastest.turning, std::abs(told->twist.w))};
    if (told->since < told_.back().since - of_late) break;
  }
  return fastest;
}

/// From what it did when it was told last, by all that had its effect since, one after the other.
Twist2 Given::slowly_at(double moment) const {
  const auto after = first_after(moment);
  if (after == told_.begin()) return {};
  const Told& last = *std::prev(after);
  Twist2 twist = last.slow;
  double time = last.since;
  const auto follow = [&](double until) {
    const Twist2 aim = told_at(time - following_.delay + rounding);
    const double linear = following_.linear_deceleration * (until - time);
    const double angular = following_.angular_deceleration * (until - time);
    twist = {slowed(twist.vx, aim.vx, linear), slowed(twist.vy, aim.vy, linear), slowed(twist.w, aim.w, angular)};
    time = until;
  };
  for (auto told = first_after(time - following_.delay); told != told_.end(); ++told) {
    if (told->since + following_.delay > moment) break;
    follow(told->since + following_.delay);
  }
  follow(moment);
  return twist;
}

/// From what was so when it was told last.
template <class Then, class Go>
Then Given::gone_on(double moment, Then Told::*then, Go go) const {
  if (told_.empty()) return {};
  const auto after = first_after(moment);
  if (after == told_.begin()) return told_.front().*then;
  const Told& last = *std::prev(after);
  return go(last.*then, last, moment - last.since);
}

Pose2 Given::slow_pose_at(double moment) const {
  return gone_on(moment, &Told::slow_at, [this](Pose2 pose, const Told& last, double time) {
    const double steps = steps_in(time);
    for (double i = 0.0; i < steps; ++i)
      pose = beyond(pose, way_of(slowly_at(last.since + i * time / steps), time / steps));
    return pose;
  });
}

/// What the base may obey: all that it was told no longer than the delay ago, and to stand, if that was long ago.
TwistRange Given::aims_at(double moment) const {
  const auto after = first_after(moment);
  if (after == told_.begin()) return {};
  auto told = std::prev(after);
  TwistRange aims{told->twist, told->twist};
  if (moment - told->since > timeout) aims = spanning(aims, {});
  for (; told->since > moment - following_.delay; --told) {
    if (told == told_.begin()) return spanning(aims, {});
    aims = spanning(aims, std::prev(told)->twist);
  }
  return aims;
}

Extremes Given::extremes_at(double moment) const {
  return gone_on(moment, &Told::extremes, [this](Extremes extremes, const Told& last, double time) {
    const double steps = steps_in(time);
    for (double i = 0.0; i < steps; ++i)
      extremes.go_on(aims_at(last.since + (i + 0.5) * time / steps), time / steps, following_);
    return extremes;
  });
}

Pose2 Given::at_once(double moment) const {
  const auto go = [](const Pose2& then, const Told& last, double time) {
    return beyond(then, way_of(last.twist, time));
  };
  return gone_on(moment, &Told::at_once, go);
}

Pose2 Given::half(double moment) const {
  const auto go = [](const Pose2& then, const Told& last, double time) {
    return beyond(then, way_of(limited(last.twist, 0.5), time));
  };
  return gone_on(moment, &Told::half, go);
}

Given::Reckoned Given::reckoned_at(double moment) const {
  return {at_once(moment), half(moment), slow_pose_at(moment)};
}

Whereabouts Given::whereabouts_at(double moment) const { return extremes_at(moment).whereabouts(slip); }

std::vector<Pose2> Given::ways_since(const Reckoned& then, double now) const {
  const Reckoned here = reckoned_at(now);
  std::vector<Pose2> ways{Pose2{}};
  for (std::size_t i = 0; i < here.size(); ++i) {
    const Pose2 way = between(then[i], here[i]);
    if (displacement(way, 1.0) > no_difference) ways.push_back(way);
  }
  return ways;
}

}  // namespace safety_control_cloud
