// SPDX-License-Identifier: BSD-3-Clause
#include "guard_control.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "guard/directions.hpp"
#include "guard/stamped.hpp"
#include "text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double least_answer_period = 0.01;  // [s]
constexpr char after_name = '\n';             // before what a sensor remembers

std::string named(const std::string& name, const std::string& text) {
  return text.empty() || name.empty() ? text : name + after_name + text;
}

Settings checked(const Settings& settings) {
  const auto problems = problems_in(settings);
  std::string all;
  for (const auto& sentence : problems) all += (all.empty() ? "" : "; ") + sentence;
  if (!all.empty()) throw std::invalid_argument(all);
  return settings;
}

std::vector<GuardSensor> sensors_by(const Settings& settings, const Guard& guard) {
  std::vector<GuardSensor> sensors;
  for (const SensorSettings& sensor : sensors_of(settings)) sensors.emplace_back(sensor, settings, guard);
  return sensors;
}

}  // namespace

GuardControl::GuardControl(const Settings& settings)
    : settings_(checked(settings)),
      guard_(settings_),
      sensors_(sensors_by(settings_, guard_)),
      closed_(settings_.switches),
      memory_(settings_),
      given_(following_of(settings_)) {}

void GuardControl::adopt(const Settings& settings) {
  const Settings checked_ones = checked(settings);
  const bool same = sensors_of(checked_ones) == sensors_of(settings_);
  if (!(checked_ones.switches == settings_.switches)) closed_ = ClosedEdges(checked_ones.switches);
  settings_ = checked_ones;
  guard_ = Guard(settings_);
  if (!same) {
    sensors_ = sensors_by(settings_, guard_);
    memory_.forget();
  }
  for (GuardSensor& sensor : sensors_) sensor.adopt(settings_, guard_);
  memory_.adopt(settings_);
  given_.follow(following_of(settings_));
  override_.adopt(settings_);
}

void GuardControl::forget_losses() {
  memory_.forget();
  unplaced_.forget();
  closed_.reset();
  for (GuardSensor& sensor : sensors_) sensor.forget_losses();
}

std::vector<std::string> GuardControl::remembered() const {
  std::vector<std::string> texts;
  for (const GuardSensor& sensor : sensors_) texts.push_back(named(written_name(sensor), sensor.remembered()));
  for (const std::string& text : unplaced_.texts()) texts.push_back(text);
  texts.push_back(memory_.remembered());
  return texts;
}

bool GuardControl::recall(const std::vector<std::string>& remembered) {
  unplaced_.forget();
  for (const std::string& line : remembered)
    if (!line.empty() && !go_on_with(line)) unplaced_.note(line);
  return !unplaced_.any();
}

std::string GuardControl::written_name(const GuardSensor& sensor) const {
  return settings_.sensors.empty() ? "" : sensor.name();
}

/// Who goes on with a line already, does not take another one in its place.
bool GuardControl::go_on_with(const std::string& line) {
  if (memory_.remembered().empty() && memory_.recall(line)) return true;
  const std::size_t end = line.find(after_name);
  const bool is_named = end != std::string::npos;
  const std::string name = is_named ? line.substr(0, end) : "";
  const auto is_its_own = [&](const GuardSensor& one) { return written_name(one) == name; };
  const auto sensor = std::find_if(sensors_.begin(), sensors_.end(), is_its_own);
  return sensor != sensors_.end() && sensor->remembered().empty() &&
         sensor->recall(is_named ? line.substr(end + 1) : line);
}

double GuardControl::until_silent(double now) const {
  double soonest = closed_.until_silent(now);
  const double left = wanted_ ? settings_.command_timeout - (now - wanted_at_) : 0.0;
  if (left > 0.0) soonest = std::min(soonest, left);
  for (const GuardSensor& sensor : sensors_) soonest = std::min(soonest, sensor.until_silent(now));
  return soonest;
}

double GuardControl::answer_period() const {
  double least = std::min(1.0 / settings_.publish_rate, settings_.stopping.sensor_period);
  for (const GuardSensor& sensor : sensors_) least = std::min(least, sensor.law().sensor_period);
  return std::max(least_answer_period, least);
}

void GuardControl::see(const Reading& reading, const Origin& origin, const Instant& now, std::size_t sensor) {
  const auto look = sensors_[sensor].see(reading, origin, now, given_);
  const Went went{odometry_, given_};
  if (memory_.note_breaks(went, now))
    for (GuardSensor& one : sensors_) one.forget_poses();
  if (!look) return explain_blindness(sensor, origin, now);
  const auto pose = memory_.note(sensor, *look, went, now);
  const bool is_any_lost = sensors_[sensor].note_pose(pose, now.steady);
  if (!is_any_lost || !pose || !memory_.remembers()) return;
  const auto robot = memory_.by_odometry_at(look->stamp, went, now);
  sensors_[sensor].explain_loss(memory_.resting(look->outlook, *robot, now), settings_.memory_time, now.steady);
}

void GuardControl::explain_blindness(std::size_t sensor, const Origin& origin, const Instant& now) {
  GuardSensor& blind = sensors_[sensor];
  const auto outlook = blind.outlook_if_blind(origin.placing);
  const auto robot = memory_.by_odometry_at(blind.taken_at(origin, now), {odometry_, given_}, now);
  if (outlook && robot) blind.explain_blindness(memory_.resting(*outlook, *robot, now));
}

void GuardControl::want(const Command& wanted, const Instant& now, std::optional<double> stamp) {
  const StampLimits limits{settings_.command_max_age, settings_.stamp_tolerance};
  unwanted_ = stamp ? refusal_of_stamp(*stamp, now.ros, limits) : std::nullopt;
  wanted_ = wanted;
  wanted_at_ = now.steady;
}

void GuardControl::note_switch(std::size_t which, Edge edge, bool touched, const Instant& now) {
  closed_.note(which, edge, touched, now.steady);
}

void GuardControl::note_about_switch(std::size_t which, std::optional<Doubt> doubt) {
  closed_.note_outside(which, std::move(doubt));
}

OverrideReply GuardControl::ask_override(const OverrideWish& wish, const Instant& now) {
  return override_.ask(wish, settings_, doubt_of(known_at(now)), now.steady);
}

/// One sensor that is not required, and in doubt, is as good as not there; but not for a change of the settings.
std::vector<Known> GuardControl::known_at(const Instant& now) {
  std::vector<Known> all;
  std::vector<bool> shows(sensors_.size(), false);
  last_.doubts.clear();
  if (const auto doubt = odometry_.doubt_at(now.ros)) last_.doubts.push_back("odometry: " + *doubt);
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    GuardSensor& sensor = sensors_[i];
    sensor.wait(now);
    Known known = sensor.known_at(now, odometry_, given_);
    const auto doubt = doubt_of(known);
    if (doubt && !sensor.is_required())
      last_.doubts.push_back(words(sensor.name(), ": ", name_of(doubt->cause), ", ", doubt->reason));
    if (known.is_placed && !known.doubt)
      last_.doubts.push_back(
          words(sensor.name(), ": ", name_of(known.lost->cause), ", before what is known to stand there"));
    const bool is_absent = known.doubt || (known.lost && known.lost->cause == Cause::Blind);
    if (is_absent && !sensor.is_required() && !sensor.is_awaited()) continue;
    if (outside_) known.doubt = outside_;
    shows[i] = sensor.shows() && !known.is_placed;
    all.push_back(std::move(known));
  }
  if (!all.empty()) {
    for (Known& one : memory_.known_at(now, {odometry_, given_}, sensors_, shows, guard_))
      all.push_back(std::move(one));
    for (Known& one : closed_.known_at(now.steady, settings_.switch_release_time)) all.push_back(std::move(one));
    if (auto unplaced = known_of_unplaced(now)) all.push_back(*std::move(unplaced));
    return all;
  }
  Known none;
  none.doubt = outside_ ? *outside_ : Doubt{Cause::NoCloud, "no sensor is required, and none to be believed"};
  return {none};
}

std::optional<Known> GuardControl::known_of_unplaced(const Instant& now) {
  unplaced_.forget_old(now, settings_);
  if (!unplaced_.any()) return std::nullopt;
  Known known;
  known.sensor = "memory";
  known.doubt = unplaced_.doubt();
  known.hint = Unplaced::hint;
  return known;
}

UnderWay GuardControl::under_way(const Twist2& wanted, const Instant& now) const {
  const double until_told_anew = std::max(1.0 / settings_.publish_rate, settings_.stopping.sensor_period);
  const auto measured = odometry_.twist_at(now.ros);
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
      return standing(one.doubt->cause, one.doubt->reason, outside_ ? "" : one.sensor, one.lost ? "" : one.hint);
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
  last_.hint = std::move(allowed.hint);
  last_.in_view = allowed.in_view;
  last_.override_left = override_.left(now.steady);
  last_.sight = sight_of(last_.sensor);
  last_.stuck = meant && allowed.factor == 0.0 && !stands(in_plane(*wanted_));
  if (last_.stuck && !was_stuck) last_.stuck_since = now.steady;
  last_.open = 0;
  given_.note(in_plane(last_.given), now.steady);
  return last_;
}

const Sight& GuardControl::sight_of(const std::string& sensor) const {
  const auto decided = [&](const GuardSensor& one) { return one.name() == sensor; };
  const auto found = std::find_if(sensors_.begin(), sensors_.end(), decided);
  return (found == sensors_.end() ? sensors_.front() : *found).counted();
}

}  // namespace safety_control_cloud
