// SPDX-License-Identifier: BSD-3-Clause
#include "guard_control.hpp"

#include <algorithm>
#include <stdexcept>

#include "guard/directions.hpp"
#include "guard/stamped.hpp"
#include "look/field_of_view.hpp"
#include "look/outlook.hpp"
#include "text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double long_on_its_way = 0.2;  ///< [s] what comes later after its stamp than this may have one that is off

Settings checked(const Settings& settings) {
  const auto problems = problems_in(settings);
  std::string all;
  for (const auto& sentence : problems) all += (all.empty() ? "" : "; ") + sentence;
  if (!all.empty()) throw std::invalid_argument(all);
  return settings;
}

Law law_of(const Settings& settings) {
  Law law;
  law.sensor_period = settings.stopping.sensor_period;
  law.latency = settings.latency;
  law.base_reaction = settings.base_reaction;
  law.linear_deceleration = settings.stopping.base_deceleration;
  law.angular_deceleration = settings.angular_deceleration;
  law.obstacle_speed = settings.obstacle_speed;
  law.escape_speed = settings.escape_speed;
  law.noise = settings.noise;
  law.min_points = settings.corridor.min_points;
  return law;
}

Following following_of(const Settings& settings) {
  return {settings.latency + settings.base_reaction, settings.stopping.base_deceleration,
          settings.angular_deceleration};
}

Surroundings surroundings_of(const Settings& settings, const Guard& guard) {
  const FrameCorridor& band = settings.frame_corridor;
  return {guard.outline(), {band.bottom, band.top, guard.reach(settings.source_timeout), own_boxes_of(settings)}};
}

/// Why a sensor that saw until now is lost where it looks, and only there.
std::optional<Doubt> loss_in(const Answer& answer, std::size_t min_points) {
  if (const auto* doubt = std::get_if<Doubt>(&answer)) {
    return doubt->cause == Cause::Blind ? std::optional(*doubt) : std::nullopt;
  }
  const auto& [sight, loss] = std::get<Seen>(answer);
  if (loss) return Doubt{loss->cause, loss->reason};
  if (sight.too_close > 0 && sight.too_close + sight.inside >= min_points)
    return Doubt{Cause::Seen, "something is too close to measure"};
  return std::nullopt;
}

}  // namespace

GuardControl::GuardControl(const Settings& settings)
    : settings_(checked(settings)),
      guard_(settings_, law_of(settings_)),
      sensor_(sensor_settings(settings_)),
      around_(surroundings_of(settings_, guard_)),
      given_(following_of(settings_)) {}

void GuardControl::adopt(const Settings& settings) {
  settings_ = checked(settings);
  guard_ = Guard(settings_, law_of(settings_));
  sensor_.adopt(sensor_settings(settings_));
  given_.follow(following_of(settings_));
  around_ = surroundings_of(settings_, guard_);
  override_.adopt(settings_);
  taken_.reset();  // what was collected was collected within other limits
}

bool GuardControl::recall(const std::vector<std::string>& remembered) {
  return remembered.size() == 1 && sensor_.recall(remembered.front());
}

void GuardControl::see(const Reading& reading, const Origin& origin, const Instant& now, Crop crop) {
  sensor_.see(reading, origin, now, crop);
  const Answer& answer = sensor_.answer();
  if (std::holds_alternative<Seen>(answer)) take(reading, origin, now);
  if (std::holds_alternative<Seen>(answer)) was_sound_ = true;
}

void GuardControl::take(const Reading& reading, const Origin& origin, const Instant& now) {
  const Settings by = sensor_settings(settings_);
  const Outlook outlook = std::get<Outlook>(outlook_of(by, origin.placing));  // there is one, or nothing were seen
  const View view = view_in(reading, by);
  around_.look(view, outlook);
  const auto field = field_of(view, Sense::Either);
  const auto* seen = std::get_if<FieldOfView>(&field);
  const double on_its_way = by.stamp_tolerance > 0.0 ? std::max(0.0, now.ros - origin.stamp) : 0.0;
  taken_ = Taken{now, on_its_way, eye_of(outlook, seen ? *seen : FieldOfView{})};
}

void GuardControl::want(const Command& wanted, const Instant& now, std::optional<double> stamp) {
  const StampLimits limits{settings_.command_max_age, settings_.stamp_tolerance};
  unwanted_ = stamp ? refusal_of_stamp(*stamp, now.ros, limits) : std::nullopt;
  wanted_ = wanted;
  wanted_at_ = now.steady;
}

OverrideReply GuardControl::ask_override(const OverrideWish& wish, const Instant& now) {
  sensor_.wait(now);
  return override_.ask(wish, settings_, doubt_of(known_at(now)), now.steady);
}

Known GuardControl::known_at(const Instant& now) const {
  Known known;
  known.sensor = name_of(settings_.input);
  if (const auto* doubt = std::get_if<Doubt>(&sensor_.answer())) known.doubt = *doubt;
  if (auto lost = loss_in(sensor_.answer(), settings_.corridor.min_points); lost && was_sound_) {
    known.lost = std::move(lost);
    known.doubt.reset();
  }
  if (outside_) known.doubt = outside_;
  if (!taken_) {
    if (!known.doubt) known.doubt = Doubt{Cause::NoCloud, "no cloud has been seen by these settings yet"};
    return known;
  }
  known.around = &around_;
  known.age = std::max(now.steady - taken_->arrival.steady, now.ros - taken_->arrival.ros) + taken_->time_to_arrive;
  known.ways = ways_since_look(now);
  known.eye = taken_->eye;
  return known;
}

/// By odometry, where it spans the time; where the stamp may be off, also as if it had been taken when it came.
std::vector<Pose2> GuardControl::ways_since_look(const Instant& now) const {
  const double on_its_way = taken_->time_to_arrive;
  const auto way = odometry_.way_since(taken_->arrival.ros - on_its_way, now.ros);
  const auto way_since_arrival = odometry_.way_since(taken_->arrival.ros, now.ros);
  if (!way || !way_since_arrival) return given_.ways_since(taken_->arrival.steady - on_its_way, now.steady);
  if (on_its_way <= long_on_its_way) return {*way};
  return {*way, *way_since_arrival};
}

std::vector<Twist2> GuardControl::under_way(const Instant& now) const {
  std::vector<Twist2> twists = given_.under_way(now.steady);
  if (const auto twist = odometry_.twist_at(now.ros)) twists.push_back(*twist);
  return twists;
}

/// The cause stays what the sensor is worth, so that nobody takes this for sight.
Allowed GuardControl::overridden(const Twist2& wanted, const Known& sensor, const Instant& now) const {
  Allowed allowed = guard_.at_most(wanted, override_.speed());
  const auto doubt = doubt_of(sensor);
  if (doubt) allowed.cause = doubt->cause;
  allowed.reason = words("~override, ", measured(override_.left(now.steady), "s"), " left",
                         doubt ? ", in spite of this: " + doubt->reason : "");
  return allowed;
}

Allowed GuardControl::allowed_now(const Instant& now, const std::vector<Known>& known) const {
  const auto standing = [](Cause cause, std::string reason) {
    return Allowed{0.0, 0.0, std::nullopt, {}, cause, std::move(reason)};
  };
  const Known& sensor = known.front();
  const bool overrides = override_.covers(sensor, now.steady);
  if (sensor.doubt && !overrides) return standing(sensor.doubt->cause, sensor.doubt->reason);
  if (!wanted_) return standing(Cause::NoCommand, "nobody has commanded the robot yet");
  const double age = now.steady - wanted_at_;
  if (age > settings_.command_timeout) return standing(Cause::NoCommand, "no command for " + measured(age, "s"));
  if (unwanted_) return standing(Cause::BadCommand, *unwanted_);
  if (is_absurd(*wanted_)) return standing(Cause::BadCommand, "the command is no motion that a robot can drive");
  const Twist2 wanted = in_plane(*wanted_);
  Allowed allowed = overrides ? overridden(wanted, sensor, now) : guard_.allowed(wanted, under_way(now), known);
  const bool dead = fastest_point(guard_.outline(), limited(wanted, allowed.factor)) < settings_.min_speed;
  if (allowed.factor < 1.0 && dead) allowed.factor = 0.0;
  return allowed;
}

const Guarded& GuardControl::answer(const Instant& now) {
  sensor_.wait(now);
  if (std::holds_alternative<Doubt>(sensor_.answer()) && !loss_in(sensor_.answer(), 1)) was_sound_ = false;
  const std::vector<Known> known{known_at(now)};
  Allowed allowed = allowed_now(now, known);
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
  last_.override_left = override_.left(now.steady);
  last_.sight = sensor_.counted();
  last_.stuck = meant && allowed.factor == 0.0 && !stands(in_plane(*wanted_));
  if (last_.stuck && !was_stuck) last_.stuck_since = now.steady;
  given_.note(in_plane(last_.given), now.steady);
  last_.open = last_.stuck ? open_directions(now, known) : std::uint8_t{0};
  return last_;
}

std::uint8_t GuardControl::open_directions(const Instant& now, const std::vector<Known>& known) const {
  std::uint8_t open = 0;
  const auto moving = under_way(now);
  for (const Direction& direction : directions) {
    const Twist2 wanted = at_speed(guard_.outline(), direction, std::max(settings_.escape_speed, settings_.min_speed));
    const Twist2 given = limited(wanted, guard_.allowed(wanted, moving, known).factor);
    if (!stands(given) && fastest_point(guard_.outline(), given) >= settings_.min_speed) open |= direction.bit;
  }
  return open;
}

}  // namespace safety_control_cloud
