// SPDX-License-Identifier: BSD-3-Clause
// What a base may be doing still.
#include <algorithm>
#include <cmath>

#include "command.hpp"
#include "given.hpp"
#include "shares.hpp"

namespace safety_control_cloud {
namespace {

constexpr double step = 0.02;  ///< [s] in which what the slowest base does is looked at

/// [m/s], [rad/s] by which a base that lags may be faster than one that brakes as slowly as it can.
constexpr double lagging_speed = 0.015, lagging_turning = 0.1;
constexpr double measures_nothing = 0.3;  ///< of its speed: some odometry tells poses, and no twists

double size_of(const Twist2& twist) { return std::max({std::abs(twist.vx), std::abs(twist.vy), std::abs(twist.w)}); }

Twist2 sum(const Twist2& a, const Twist2& b) { return {a.vx + b.vx, a.vy + b.vy, a.w + b.w}; }

}  // namespace

std::vector<Twist2> Given::under_way(double now, const std::optional<Twist2>& measured) const {
  std::vector<Twist2> twists{told_at(now - following_.delay)};
  const auto add = [&](const Twist2& twist) {
    if (std::none_of(twists.begin(), twists.end(), [&](const Twist2& other) { return same(twist, other); }))
      twists.push_back(twist);
  };
  add(slowly_at(now));
  for (auto told = told_.rbegin(); told != told_.rend() && told->since >= now - following_.delay; ++told)
    add(told->twist);
  if (const auto steady = twists.size() > 1 ? as_if_steady(twists, now) : std::nullopt) {
    twists = {told_.back().twist};
    add(sum(steady->twist, steady->rest));
    add(difference(steady->twist, steady->rest));
    if (measured) add(steady->with(*measured));
  } else if (measured) {
    add(*measured);
  }
  return twists;
}

/// Each of them holds no longer than until the next has its effect. Where all are nearly shares of one motion, that
/// comes to one share k, steady for the delay, with the stopping way of who obeys as late and as slowly as he can: k
/// delay + k^2 t_b / 2 (speed/law.hpp). Who obeys sooner has less of that before him.
std::optional<Given::Steady> Given::as_if_steady(const std::vector<Twist2>& twists, double now) const {
  const auto by_size = [](const Twist2& a, const Twist2& b) { return size_of(a) < size_of(b); };
  const Twist2 whole = *std::max_element(twists.begin(), twists.end(), by_size);
  Rest rest(whole);
  for (const Twist2& twist : twists) rest.add(twist);
  const double delay = following_.delay, steps = std::ceil(delay / step), time = delay / steps;
  const double at_first = rest.add(slowly_at(now));
  double share = at_first, way = 0.0;
  for (double i = 1.0; i <= steps; ++i) {
    const double next = rest.add(slowly_at(now + i * time));
    way += time * std::max(share, next);
    share = next;
  }
  if (!rest.is_slight()) return std::nullopt;
  const double braking =
      std::max(speed_of(whole) / following_.linear_deceleration, std::abs(whole.w) / following_.angular_deceleration);
  const double needed = way + 0.5 * braking * share * share;
  const double steady = 2.0 * needed / (delay + std::sqrt(delay * delay + 2.0 * braking * needed));
  return Steady{limited(whole, steady), limited(whole, at_first), rest.most()};
}

/// What is measured of the motion at most as large as it may be now is in it already; the rest is not.
Twist2 Given::Steady::with(const Twist2& measured) const {
  return sum(twist, difference(measured, limited(now, share_in(now, measured))));
}

/// By the axis that takes longer to brake, which is the one that keeps to its rate.
double Given::slowing_along(const Twist2& wanted, double now, double time,
                            const std::optional<Twist2>& measured) const {
  if (!measured || stands(wanted)) return 0.0;
  const Twist2 slow_now = slowly_at(now), slow = slowly_at(now + following_.delay);
  Rest rest(wanted);
  rest.add(told_at(now - following_.delay));
  for (auto told = first_after(now - following_.delay); told != told_.end(); ++told) rest.add(told->twist);
  for (const Twist2& twist : {slow_now, slow}) rest.add(twist);
  if (!rest.is_slight()) return 0.0;
  const double speed = speed_of(wanted), turning = std::abs(wanted.w);
  const double to_stop = speed / following_.linear_deceleration, to_face = turning / following_.angular_deceleration;
  const bool by_speed = to_stop >= to_face;
  const auto share_of = [&](const Twist2& twist) {
    return by_speed ? dot(linear(twist), linear(wanted)) / (speed * speed) : twist.w / wanted.w;
  };
  const double tolerated = by_speed ? lagging_speed / speed : lagging_turning / turning;
  const double at_most = share_of(slow_now), is = share_of(*measured);
  if (is > at_most + tolerated || is < measures_nothing * at_most) return 0.0;
  return std::max(0.0, std::min(1.0, share_of(slow)) - time / std::max(to_stop, to_face));
}

}  // namespace safety_control_cloud
