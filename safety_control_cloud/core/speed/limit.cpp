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
    const double needed = std::max(duration(least), stopping_time(share, response.delay, response.braking));
    return std::max(std::numeric_limits<double>::min(), needed * (1.0 - 1e-9));
  }
  Limit answer(double most, double share, const Contact& first) const {
    double factor = greatest_factor(first.time, response, share);
    const double with_noise = std::max(first.time - by_noise, 0.5 * first.time);
    if (factor > share) factor = std::max(share, greatest_factor(with_noise, response, share));
    return {std::min(most, factor), first, false};
  }
};

/// `suspect`: what stood in the way of a greater factor; where it still does, nothing else is looked at.
template <class TimeOf>
Limit tried(const Question& question, const Factors& factors, double share, std::optional<std::size_t> suspect,
            TimeOf time_of) {
  const double hopeless = question.hopeless(factors.least, share);
  if (suspect && question.law.min_points <= 1) {
    const double time = time_of(question.obstacles.points[*suspect]);
    if (time < hopeless) return question.answer(factors.most, share, {time, suspect});
  }
  return question.answer(factors.most, share, contact(question.obstacles, question.law.min_points, hopeless, time_of));
}

Limit tried_by_fan(const Question& question, const Factors& factors, const Fan& fan,
                   std::optional<std::size_t> suspect) {
  std::vector<Sweep> sweeps;
  for (const Twist2& twist : fan.twists) sweeps.push_back(question.sweep(twist, fan.widening, factors.most, fan.share));
  return tried(question, factors, fan.share, suspect, [&](const Point2& point) {
    double first = std::numeric_limits<double>::infinity();
    for (const Sweep& sweep : sweeps) first = std::min(first, sweep.time_to_contact(point));
    return first;
  });
}

/// By the path of the wish and a margin to both of its sides, or by the fan: each is a bound, so the greater holds.
Limit tried(const Question& question, const Factors& factors, std::optional<std::size_t> suspect) {
  const Straying off = question.straying_at(factors);
  const Sweep sweep = question.sweep(off.widening, factors.most, off.share);
  const Limit limit =
      tried(question, factors, off.share, suspect, [&](const Point2& point) { return sweep.time_to_contact(point); });
  if (limit.factor >= factors.most) return limit;
  const auto fan = question.fan_at(factors);
  if (!fan || !(fan->widening < off.widening)) return limit;
  const Limit by_fan = tried_by_fan(question, factors, *fan, limit.contact.point);
  return by_fan.factor > limit.factor ? by_fan : limit;
}

/// Without regard to what is inside the margin already and may be left: that is touched at once.
Limit by_the_law(const Question& question) {
  Limit limit = tried(question, {1.0, 1.0}, std::nullopt);
  if (limit.factor >= 1.0) return limit;
  for (double most = 1.0; most > least_step; most *= step) {
    limit = tried(question, {step * most, most}, limit.contact.point);
    if (limit.factor >= step * most) return limit;
  }
  return tried(question, {0.0, least_step}, limit.contact.point);
}

/// The time to contact of what is outside; of what is inside, whether it comes nearer.
double time_on_the_way_out(const Question& question, const Sweep& sweep, double duration, double off,
                           const Point2& point) {
  const double time = sweep.time_to_contact(point);
  if (time > 0.0 || question.obstacles.widening > 0.0) return time;
  const double allowance = allowance_for(question.outline.signed_distance(point), question.law.noise) - off;
  const bool nearer = comes_nearer(question.outline, question.wanted, point, duration, allowance);
  return nearer ? 0.0 : std::numeric_limits<double>::infinity();
}

Limit on_the_way_out(const Question& question, double factor) {
  const Straying off = question.straying_at({0.0, factor});
  const double most = std::max(factor, off.share);
  const Sweep sweep = question.sweep(off.widening, factor, off.share);
  const auto time_of = [&](const Point2& point) {
    return time_on_the_way_out(question, sweep, question.duration(most), off.widening, point);
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
  const auto first =
      contact(obstacles, law.min_points, needed, [&](const Point2& point) { return sweep.time_to_contact(point); });
  return first.time >= needed;
}

/// On the way out a robot that strays less, as it drives less, may pass what another may not.
Limit limit_from(const Question& question, double escape, double slowing) {
  Limit best = by_the_law(question);
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
  Limit least = under_way.twists.empty() ? limit_from(question, escape, 0.0) : Limit{};
  for (const Twist2& twist : under_way.twists) {
    if (!is_sound(twist)) return standing;
    question.under_way = twist;
    const Limit limit = limit_from(question, escape, under_way.slowing);
    if (limit.factor < least.factor) least = limit;
  }
  return least;
}

}  // namespace safety_control_cloud
