// SPDX-License-Identifier: BSD-3-Clause
#include "limit.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "../path/escape.hpp"
#include "fan.hpp"

namespace safety_control_cloud {
namespace {

constexpr double step = 0.9;         // from one factor that is tried to the next
constexpr double least_step = 0.03;  // below it the last margin serves for all

/// Who wants what, and what is known: the arguments of limit() that never change while it thinks.
struct Question {
  const Outline& outline;
  const Law& law;
  const Obstacles& obstacles;
  const Age& age;
  Twist2 under_way, wanted;
  Response response;
  double by_noise;  ///< [s] of the wanted twist that noise of the sensor may take: no more than half the margin

  Straying straying_at(const Factors& factors) const {
    return straying(outline, law, response, under_way, wanted, factors);
  }
  std::optional<Fan> fan_at(const Factors& factors) const {
    return fan(outline, law, response, under_way, wanted, factors);
  }
  /// [s] of the wanted twist until the robot stands.
  double duration(double factor) const { return stopping_time(factor, response.reaction, response.braking); }
  Sweep sweep(double widening, double factor, double share) const { return sweep(wanted, widening, factor, share); }
  Sweep sweep(const Twist2& twist, double widening, double factor, double share) const {
    const double nearer = approach(law, age, response, factor, share);
    const double horizon = (duration(std::max(factor, share)) + by_noise) * (1.0 + 1e-9);
    return {outline, twist, obstacles.widening + widening + nearer, horizon};
  }
  /// [s] A contact before leaves less than the least factor, whatever else there is.
  double hopeless(double least, double share) const {
    const double time = least_time(least, response, share);
    const double needed = least > share ? std::min(time + by_noise, 2.0 * time) : time;  // see answer()
    return std::max(std::numeric_limits<double>::min(), needed * (1.0 - 1e-9));
  }
  Limit answer(double most, double share, const Contact& first) const {
    double factor = greatest_factor(first.time, response, share);
    const double with_noise = std::max(first.time - by_noise, 0.5 * first.time);
    if (factor > share) factor = std::max(share, greatest_factor(with_noise, response, share));
    return {std::min(most, factor), first, false};
  }
};

/// What stood in the way of greater factors, the latest first: most likely one of it does of the next.
class Suspects {
 public:
  template <class IsGuilty>
  bool any(const IsGuilty& is_guilty) {
    const auto found = std::find_if(points_.begin(), points_.end(), is_guilty);
    if (found == points_.end()) return false;
    std::rotate(points_.begin(), found, found + 1);
    return true;
  }
  void add(std::size_t point) {
    points_.erase(std::remove(points_.begin(), points_.end(), point), points_.end());
    if (points_.size() == most) points_.pop_back();
    points_.insert(points_.begin(), point);
  }

 private:
  static constexpr std::size_t most = 4;
  std::vector<std::size_t> points_;
};

/// Where a suspect still stands in the way, nothing else is looked at.
template <class TimeOf>
Limit tried(const Question& question, const Factors& factors, double share, Suspects& suspects, TimeOf time_of) {
  const double hopeless = question.hopeless(factors.least, share);
  Contact first;
  const bool is_hopeless = question.law.min_points <= 1 && suspects.any([&](std::size_t point) {
    const double time = time_of(question.obstacles.points[point], first.time);
    if (time < first.time) first = {time, point};
    return first.time < hopeless;
  });
  if (!is_hopeless) {
    first = contact(question.obstacles, question.law.min_points, 0.0, time_of, first);
    if (first.point) suspects.add(*first.point);
  }
  return question.answer(factors.most, share, first);
}

Limit tried_by_fan(const Question& question, const Factors& factors, const Fan& fan, Suspects& suspects) {
  std::vector<Sweep> sweeps;
  for (const Twist2& twist : fan.twists) sweeps.push_back(question.sweep(twist, fan.widening, factors.most, fan.share));
  return tried(question, factors, fan.share, suspects, [&](const Point2& point, double before) {
    for (const Sweep& sweep : sweeps) before = std::min(before, sweep.time_to_contact(point, before));
    return before;
  });
}

/// By the path of the wish and a margin to both of its sides, or by the fan: each is a bound, so the greater holds.
Limit tried(const Question& question, const Factors& factors, Suspects& suspects) {
  const Straying off = question.straying_at(factors);
  const Sweep sweep = question.sweep(off.widening, factors.most, off.share);
  const Limit limit = tried(question, factors, off.share, suspects, time_by(sweep));
  if (limit.factor >= factors.most) return limit;
  const auto fan = question.fan_at(factors);
  if (!fan || !(fan->widening < off.widening)) return limit;
  const Limit by_fan = tried_by_fan(question, factors, *fan, suspects);
  return by_fan.factor > limit.factor ? by_fan : limit;
}

/// Without regard to what is inside the margin already and may be left: that is touched at once.
Limit by_the_law(const Question& question, Suspects& suspects) {
  Limit limit = tried(question, {1.0, 1.0}, suspects);
  if (limit.factor >= 1.0) return limit;
  for (double most = 1.0; most > least_step; most *= step) {
    limit = tried(question, {step * most, most}, suspects);
    if (limit.factor >= step * most) return limit;
  }
  return tried(question, {0.0, least_step}, suspects);
}

/// The time to contact of what is outside; of what is inside, whether it comes nearer.
double time_on_the_way_out(const Question& question, const Sweep& sweep, double duration, double off,
                           const Point2& point, double before) {
  const double time = sweep.time_to_contact(point, before);
  if (time > 0.0 || question.obstacles.widening > 0.0) return time;
  const double allowance = allowance_for(question.outline.signed_distance(point), question.law.noise) - off;
  const bool nearer = comes_nearer(question.outline, question.wanted, point, duration, allowance);
  return nearer ? 0.0 : std::numeric_limits<double>::infinity();
}

Limit on_the_way_out(const Question& question, double factor) {
  const Straying off = question.straying_at({0.0, factor});
  const double most = std::max(factor, off.share);
  const Sweep sweep = question.sweep(off.widening, factor, off.share);
  const auto time_of = [&](const Point2& point, double before) {
    return time_on_the_way_out(question, sweep, question.duration(most), off.widening, point, before);
  };
  const double hopeless = question.hopeless(0.0, off.share);
  Limit limit =
      question.answer(factor, off.share, contact(question.obstacles, question.law.min_points, hopeless, time_of));
  limit.is_escape = limit.factor > 0.0;
  return limit;
}

/// Whether the robot comes to stand in time if it goes on for the delay, and then brakes along the path; but for what
/// noise of the sensor may have taken from that since it was given its speed, and of that no more than half the margin.
bool slows_in_time(const Question& question) {
  const auto& [outline, law, obstacles, age, under_way, wanted, response, by_noise] = question;
  const Straying off = question.straying_at({0.0, 0.0, true});
  const Sweep sweep = question.sweep(off.widening, 0.0, off.share);
  const double needed = std::max(std::numeric_limits<double>::min(),
                                 stopping_time(off.share, response.delay, response.braking) - by_noise);
  const auto first = contact(obstacles, law.min_points, needed, time_by(sweep));
  return first.time >= needed;
}

/// On the way out a robot that strays less, as it drives less, may pass what another may not.
Limit limit_from(const Question& question, double escape, double slowing, Suspects& suspects) {
  Limit best = by_the_law(question, suspects);
  if (best.factor < slowing && slows_in_time(question)) best.factor = slowing;
  for (double factor = escape; factor > best.factor && factor > 0.2 * escape; factor *= 0.5) {
    const Limit out = on_the_way_out(question, factor);
    if (out.factor > best.factor) best = out;
  }
  return best;
}

}  // namespace

Limit limit(const Outline& outline, const Law& law, const Obstacles& obstacles, const Age& age,
            const UnderWay& under_way, const Twist2& wanted) {
  const Limit standing{0.0, {0.0, std::nullopt}, false};
  if (!is_sound(wanted)) return standing;
  const double fastest = fastest_point(outline, wanted);
  if (fastest == 0.0) return {};
  const double escape = std::min(1.0, law.escape_speed / fastest);
  const double by_noise = std::min(2.0 * law.noise, 0.5 * outline.margin()) / fastest;
  Question question{outline, law, obstacles, age, {}, wanted, response_to(law, age, wanted), by_noise};
  Suspects suspects;
  Limit least = under_way.twists.empty() ? limit_from(question, escape, 0.0, suspects) : Limit{};
  for (const Twist2& twist : under_way.twists) {
    if (!is_sound(twist)) return standing;
    question.under_way = twist;
    const Limit limit = limit_from(question, escape, under_way.slowing, suspects);
    if (limit.factor < least.factor) least = limit;
  }
  return least;
}

}  // namespace safety_control_cloud
