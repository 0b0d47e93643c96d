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

constexpr double begins_after = 0.2;  ///< [s] that odometry must go on before it is asked

Settings checked(const Settings& settings) {
  const auto problems = problems_in(settings);
  std::string all;
  for (const auto& sentence : problems) all += (all.empty() ? "" : "; ") + sentence;
  if (!all.empty()) throw std::invalid_argument(all);
  return settings;
}

Following following_of(const Settings& settings) {
  return {settings.latency + settings.base_reaction, settings.stopping.base_deceleration,
          settings.angular_deceleration};
}

OutOfSightLimits out_of_sight_by(const Settings& settings) {
  const FrameCorridor& band = settings.frame_corridor;
  return {band.bottom,           band.top, settings.memory_distance, settings.memory_time, settings.obstacle_speed,
          own_boxes_of(settings)};
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
      out_of_sight_(out_of_sight_by(settings_)),
      given_(following_of(settings_)) {}

void GuardControl::adopt(const Settings& settings) {
  const Settings checked_ones = checked(settings);
  const bool same = sensors_of(checked_ones) == sensors_of(settings_);
  if (!(checked_ones.switches == settings_.switches)) closed_ = ClosedEdges(checked_ones.switches);
  settings_ = checked_ones;
  guard_ = Guard(settings_);
  if (!same) {
    sensors_ = sensors_by(settings_, guard_);
    out_of_sight_.forget();
  }
  for (GuardSensor& sensor : sensors_) sensor.adopt(settings_, guard_);
  out_of_sight_.limit(out_of_sight_by(settings_));
  given_.follow(following_of(settings_));
  override_.adopt(settings_);
}

void GuardControl::forget_losses() {
  out_of_sight_.forget();
  jumped_.reset();
  for (GuardSensor& sensor : sensors_) sensor.forget_losses();
}

std::vector<std::string> GuardControl::remembered() const {
  std::vector<std::string> texts;
  for (const GuardSensor& sensor : sensors_) texts.push_back(sensor.remembered());
  return texts;
}

bool GuardControl::recall(const std::vector<std::string>& remembered) {
  bool legible = remembered.size() == sensors_.size();
  for (std::size_t i = 0; i < std::min(remembered.size(), sensors_.size()); ++i)
    legible = sensors_[i].recall(remembered[i]) && legible;
  return legible;
}

double GuardControl::until_silent(double now) const {
  double soonest = std::numeric_limits<double>::infinity();
  for (const GuardSensor& sensor : sensors_) soonest = std::min(soonest, sensor.until_silent(now));
  return soonest;
}

void GuardControl::see(const Reading& reading, const Origin& origin, const Instant& now, std::size_t sensor) {
  const auto look = sensors_[sensor].see(reading, origin, now, given_);
  if (odometry_.breaks() != breaks_) note_break(now);
  if (!look) return;
  choose_whereabouts(look->stamp, now);
  const auto robot = whereabouts_at(now.ros - look->stamp, now);
  if (robot) {
    out_of_sight_.note(sensor, *look, *robot, now.steady);
  } else {
    out_of_sight_.note_unplaced(sensor, now.steady);
  }
  const auto pose = by_odometry_ && robot ? std::optional(robot->pose) : std::nullopt;
  const bool is_any_lost = sensors_[sensor].note_pose(pose, now.steady);
  if (!is_any_lost || !pose || !out_of_sight_.remembers()) return;
  const auto known = out_of_sight_.resting(look->outlook, *robot, now.steady);
  sensors_[sensor].explain(known, settings_.memory_time, now.steady);
}

/// Who waits for looks since another break, goes on to wait: that moment may have been far ahead.
void GuardControl::note_break(const Instant& now) {
  if (jumped_ || (by_odometry_ && out_of_sight_.holds_any(now.steady))) jumped_ = odometry_.goes_on_since();
  breaks_ = odometry_.breaks();
  if (!by_odometry_) return;
  out_of_sight_.forget();
  for (GuardSensor& one : sensors_) one.forget_poses();
}

/// By odometry once it goes on, with what was remembered until then; if it falls silent, by what the base is told, but
/// not what it was to place.
void GuardControl::choose_whereabouts(double stamp, const Instant& now) {
  const bool goes_on = odometry_.is_fresh(now.ros) && odometry_.goes_on_for() >= begins_after;
  const bool speaks = goes_on && odometry_.pose_at(stamp);
  const bool holds_any = out_of_sight_.holds_any(now.steady);
  if (speaks == by_odometry_ || (by_odometry_ && holds_any)) return;
  if (const auto there = odometry_.pose_at(now.ros); speaks && holds_any && there) {
    out_of_sight_.go_on_in_frame(given_.whereabouts_at(now.steady), *there, now.steady);
  } else {
    out_of_sight_.forget();
  }
  by_odometry_ = speaks;
}

/// `age` [s] ago.
std::optional<Whereabouts> GuardControl::whereabouts_at(double age, const Instant& now) const {
  if (!by_odometry_) return given_.whereabouts_at(now.steady - age);
  const auto pose = odometry_.pose_at(now.ros - age);
  return pose ? std::optional(Whereabouts{*pose, {}, settings_.odometry_drift}) : std::nullopt;
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

/// One sensor that is not required, and in doubt, is as good as not there.
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
    const bool is_absent = known.doubt || (known.lost && known.lost->cause == Cause::Blind);
    if (is_absent && !sensor.is_required()) continue;
    if (outside_) known.doubt = outside_;
    shows[i] = true;
    all.push_back(std::move(known));
  }
  if (!all.empty()) {
    for (Known& one : remembered_at(now, shows)) all.push_back(std::move(one));
    for (Known& one : closed_.known_at(now.steady, settings_.switch_release_time)) all.push_back(std::move(one));
    return all;
  }
  Known none;
  none.doubt = outside_ ? *outside_ : Doubt{Cause::NoCloud, "no sensor is required, and none to be believed"};
  return {none};
}

/// What no sensor shows any more, where odometry says that it is; or else by what the base was told, each sensor's own.
std::vector<Known> GuardControl::remembered_at(const Instant& now, const std::vector<bool>& shows) {
  Known known;
  known.sensor = "memory";
  const auto in_doubt = [&](const char* reason) {
    known.doubt = Doubt{Cause::NoOdometry, reason};
    return std::vector<Known>{known};
  };
  if (by_odometry_ && odometry_.breaks() != breaks_ && out_of_sight_.holds_any(now.steady))
    return in_doubt("odometry jumped or paused, and what is out of sight cannot be placed");
  const auto jumped = [&](const GuardSensor& sensor) {
    return sensor.is_required() && !sensor.has_looked_since(*jumped_);
  };
  if (jumped_ && std::any_of(sensors_.begin(), sensors_.end(), jumped))
    return in_doubt("odometry jumped or paused, and not every sensor has looked since");
  jumped_.reset();
  if (!out_of_sight_.holds_any(now.steady)) return {};
  const bool is_placed = !by_odometry_ || odometry_.is_fresh(now.ros);
  const auto robot = is_placed ? whereabouts_at(0.0, now) : std::nullopt;
  if (!robot) return in_doubt("no odometry, and what is out of sight cannot be placed");
  known.law = sensors_.front().law();
  known.law.min_points = 1;
  known.ways = {Pose2{}};
  known.is_reckoned = !by_odometry_;
  const double reach = guard_.reach(0.0, known.law);
  remembered_.clear();
  for (std::size_t i = 0; i < (by_odometry_ ? 1 : sensors_.size()); ++i)
    remembered_.push_back(
        out_of_sight_.rings(*robot, reach, now.steady, shows, by_odometry_ ? std::nullopt : std::optional(i)));
  std::vector<Known> all;
  for (std::size_t i = 0; i < remembered_.size(); ++i) {
    // What the margin is kept for: half of it for where things are, the rest for what the robot does. What decides is
    // the nearest of many returns, not one of min_points as in a picture, and lies nearer than the thing by the noise.
    for (Ring& ring : remembered_[i])
      ring.obstacles.widening = std::max(-known.law.noise, ring.obstacles.widening - 0.5 * settings_.margin);
    known.rings = &remembered_[i];
    known.seen_by = shows[i] ? sensors_[i].eye() : std::nullopt;
    all.push_back(known);
  }
  return all;
}

std::vector<Twist2> GuardControl::under_way(const Instant& now) const {
  return given_.under_way(now.steady, odometry_.twist_at(now.ros));
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
  const auto standing = [](Cause cause, std::string reason, std::string sensor = {}) {
    return Allowed{0.0, 0.0, std::nullopt, std::move(sensor), cause, std::move(reason)};
  };
  const bool overrides = override_.covers(known, now.steady);
  for (const Known& one : known)
    if (one.doubt && !overrides) return standing(one.doubt->cause, one.doubt->reason, outside_ ? "" : one.sensor);
  if (!wanted_) return standing(Cause::NoCommand, "nobody has commanded the robot yet");
  const double age = now.steady - wanted_at_;
  if (age > settings_.command_timeout) return standing(Cause::NoCommand, "no command for " + measured(age, "s"));
  if (unwanted_) return standing(Cause::BadCommand, *unwanted_);
  if (is_absurd(*wanted_)) return standing(Cause::BadCommand, "the command is no motion that a robot can drive");
  const Twist2 wanted = in_plane(*wanted_);
  Allowed allowed = overrides ? overridden(wanted, known, now) : guard_.allowed(wanted, under_way(now), known);
  const bool dead = fastest_point(guard_.outline(), limited(wanted, allowed.factor)) < settings_.min_speed;
  if (allowed.factor < 1.0 && dead) allowed.factor = 0.0;
  return allowed;
}

const Guarded& GuardControl::answer(const Instant& now) {
  const std::vector<Known> known = known_at(now);
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
  last_.hint = std::move(allowed.hint);
  last_.in_view = allowed.in_view;
  last_.override_left = override_.left(now.steady);
  last_.sight = sight_of(last_.sensor);
  last_.stuck = meant && allowed.factor == 0.0 && !stands(in_plane(*wanted_));
  if (last_.stuck && !was_stuck) last_.stuck_since = now.steady;
  given_.note(in_plane(last_.given), now.steady);
  last_.open = last_.stuck ? open_directions(now, known) : std::uint8_t{0};
  return last_;
}

const Sight& GuardControl::sight_of(const std::string& sensor) const {
  const auto decided = [&](const GuardSensor& one) { return one.name() == sensor; };
  const auto found = std::find_if(sensors_.begin(), sensors_.end(), decided);
  return (found == sensors_.end() ? sensors_.front() : *found).counted();
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
