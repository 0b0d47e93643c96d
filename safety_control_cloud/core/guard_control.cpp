// SPDX-License-Identifier: BSD-3-Clause
#include "guard_control.hpp"

#include <algorithm>
#include <stdexcept>

#include "guard/directions.hpp"
#include "guard/stamped.hpp"
#include "text/words.hpp"

namespace safety_control_cloud {
namespace {

Settings checked(const Settings& settings) {
  const auto problems = problems_in(settings);
  std::string all;
  for (const auto& sentence : problems) all += (all.empty() ? "" : "; ") + sentence;
  if (!all.empty()) throw std::invalid_argument(all);
  return settings;
}

}  // namespace

GuardControl::GuardControl(const Settings& settings)
    : settings_(checked(settings)),
      guard_(settings_),
      perception_(settings_, guard_),
      given_(following_of(settings_)),
      answer_period_(safety_control_cloud::answer_period(settings_)) {}

void GuardControl::adopt(const Settings& settings) {
  settings_ = checked(settings);
  guard_ = Guard(settings_);
  perception_.adopt(settings_, guard_);
  given_.follow(following_of(settings_));
  answer_period_ = safety_control_cloud::answer_period(settings_);
  override_.adopt(settings_);
}

double GuardControl::until_silent(double now) const {
  const double left = wanted_ ? settings_.command_timeout - (now - wanted_at_) : 0.0;
  const double soonest = perception_.until_silent(now);
  return left > 0.0 ? std::min(soonest, left) : soonest;
}

/// A stop counts, however late it comes; what was said before it does not end it, as long as that is young enough.
void GuardControl::want(const Command& wanted, const Instant& now, std::optional<double> stamp) {
  const StampLimits limits{settings_.command_max_age, settings_.stamp_tolerance};
  auto refusal = stamp ? refusal_of_stamp(*stamp, now.ros, limits) : std::nullopt;
  const double holds = std::max(settings_.command_timeout, settings_.command_max_age);
  const bool stop_holds = stop_ && now.steady - stop_->came <= holds;
  if (stop_holds && stamp && !refusal && *stamp < stop_->stamp) return;
  if (!refusal) stop_ = stamp && stands(in_plane(wanted)) ? std::optional(Stop{*stamp, now.steady}) : std::nullopt;
  unwanted_ = std::move(refusal);
  wanted_ = wanted;
  wanted_at_ = now.steady;
}

OverrideReply GuardControl::ask_override(const OverrideWish& wish, const Instant& now) {
  return override_.ask(wish, settings_, doubt_of(known_at(now)), now.steady);
}

std::vector<Known> GuardControl::known_at(const Instant& now) {
  last_.doubts.clear();
  return perception_.known_at(now, given_, guard_, last_.doubts);
}

/// Until it is told anew by whoever is later: a look may fail to come.
UnderWay GuardControl::under_way(const Twist2& wanted, const Instant& now) const {
  const double until_told_anew = std::max(1.0 / settings_.publish_rate, settings_.stopping.sensor_period);
  const auto measured = perception_.odometry().twist_at(now.ros);
  return {given_.under_way(now.steady, measured), given_.slowing_along(wanted, now.steady, until_told_anew, measured)};
}

/// The cause stays what the sensors are worth, so that nobody takes this for sight.
Allowed GuardControl::overridden(const Twist2& wanted, const std::vector<Known>& known, const Instant& now) const {
  Allowed allowed = guard_.at_most(wanted, override_.speed());
  const auto doubt = doubt_of(known);
  if (doubt) allowed.cause = doubt->cause;
  allowed.reason = words("~override, ", measured(override_.left(now.steady), "s"), " left",
                         doubt ? ", in spite of this: " + doubt->reason : "");
  return allowed;
}

Allowed GuardControl::allowed_now(const Instant& now, const std::vector<Known>& known) const {
  const auto standing = [](Cause cause, std::string reason, std::string sensor = {}, std::string hint = {}) {
    return Allowed{0.0, 0.0, std::nullopt, std::move(sensor), cause, std::move(reason), std::move(hint)};
  };
  const bool overrides = override_.covers(known, now.steady);
  for (const Known& one : known)
    if (one.doubt && !overrides)
      return standing(one.doubt->cause, one.doubt->reason, perception_.is_in_doubt_outside() ? "" : one.sensor,
                      one.lost ? "" : one.hint);
  if (!wanted_) return standing(Cause::NoCommand, "nobody has commanded the robot yet");
  const double age = now.steady - wanted_at_;
  if (age > settings_.command_timeout) return standing(Cause::NoCommand, "no command for " + measured(age, "s"));
  if (unwanted_) return standing(Cause::BadCommand, *unwanted_);
  if (is_absurd(*wanted_)) return standing(Cause::BadCommand, "the command is no motion that a robot can drive");
  const Twist2 wanted = in_plane(*wanted_);
  Allowed allowed = overrides ? overridden(wanted, known, now) : guard_.allowed(wanted, under_way(wanted, now), known);
  const bool dead = fastest_point(guard_.outline(), limited(wanted, allowed.factor)) < settings_.min_speed;
  if (allowed.factor < 1.0 && dead) allowed.factor = 0.0;
  return allowed;
}

const Guarded& GuardControl::answer(const Instant& now) {
  const std::vector<Known> known = known_at(now);
  settle(allowed_now(now, known), now);
  if (last_.stuck) last_.open = open_directions(guard_, settings_, under_way({}, now), known);
  return last_;
}

const Guarded& GuardControl::stand(const Instant& now, const Doubt& doubt) {
  return settle({0.0, 0.0, std::nullopt, {}, doubt.cause, doubt.reason}, now);
}

const Guarded& GuardControl::settle(Allowed allowed, const Instant& now) {
  const bool was_stuck = last_.stuck;
  const bool meant = wanted_ && allowed.cause != Cause::NoCommand && allowed.cause != Cause::BadCommand;
  last_.wanted = wanted_.value_or(Command{});
  last_.given = scaled(last_.wanted, allowed.factor);
  last_.factor = allowed.factor;
  last_.time_to_contact = allowed.time_to_contact;
  last_.point = allowed.point;
  last_.sensor = allowed.sensor;
  last_.cause = allowed.cause;
  last_.reason = allowed.reason.empty() ? "the command is safe" : std::move(allowed.reason);
  last_.hint = allowed.factor > 0.0 ? std::string() : std::move(allowed.hint);
  last_.in_view = allowed.in_view;
  last_.override_left = override_.left(now.steady);
  last_.sight = perception_.sight_of(last_.sensor);
  last_.stuck = meant && allowed.factor == 0.0 && !stands(in_plane(*wanted_));
  if (last_.stuck && !was_stuck) last_.stuck_since = now.steady;
  last_.open = 0;
  given_.note(in_plane(last_.given), now.steady);
  return last_;
}

}  // namespace safety_control_cloud
