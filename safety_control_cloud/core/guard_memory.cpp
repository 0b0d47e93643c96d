// SPDX-License-Identifier: BSD-3-Clause
#include "guard_memory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "input/angle.hpp"

namespace safety_control_cloud {
namespace {

constexpr const char* what_frees =
    "a sensor sees past that, or after memory_time, or after ~reset, when somebody has looked";
constexpr const char* what_frees_who_strayed = "after memory_time, or after ~reset, when somebody has looked";
constexpr double begins_after = 0.2;  ///< [s] that odometry must go on before it is asked
constexpr double least_jump = 0.1;    ///< [m], [rad]
constexpr double soon = 0.05;         ///< [s] in which no base comes to move much otherwise

OutOfSightLimits limits_by(const Settings& settings) {
  const FrameCorridor& band = settings.frame_corridor;
  return {{band.bottom, band.top, settings.memory_distance, own_boxes_of(settings)},
          settings.memory_time,
          settings.obstacle_speed};
}

/// A sensor in a text: what a camera showed is no scan's, whatever that is named by now.
std::string written_name(const SensorSettings& sensor) {
  return (sensor.type == InputKind::Scan ? "scan/" : "") + sensor.name;
}

/// Of a sensor that has another name by now, a camera takes them over: a scan would forget what lies beside its plane.
std::vector<KeptPlace> in_order_of(const std::vector<SensorSettings>& sensors, const KeptPlaces& kept) {
  const auto first = [&](const auto& fits) {
    return static_cast<std::size_t>(std::find_if(sensors.begin(), sensors.end(), fits) - sensors.begin());
  };
  const std::size_t camera = first([](const SensorSettings& one) { return one.type != InputKind::Scan; });
  std::vector<std::size_t> by_now;
  for (const std::string& name : kept.sensors) {
    const std::size_t same = first([&](const SensorSettings& one) { return written_name(one) == name; });
    by_now.push_back(same < sensors.size() ? same : camera < sensors.size() ? camera : 0);
  }
  std::vector<KeptPlace> places = kept.all;
  for (KeptPlace& place : places) place.sensor = by_now[place.sensor];
  return places;
}

}  // namespace

GuardMemory::GuardMemory(const Settings& settings)
    : out_of_sight_(limits_by(settings)),
      sensors_(sensors_of(settings)),
      odometry_drift_(settings.odometry_drift),
      margin_(settings.margin),
      time_(settings.memory_time),
      fastest_(settings.max_speed),
      fastest_turn_(settings.max_turn) {}

void GuardMemory::adopt(const Settings& settings) {
  out_of_sight_.limit(limits_by(settings));
  sensors_ = sensors_of(settings);
  odometry_drift_ = settings.odometry_drift;
  margin_ = settings.margin;
  time_ = settings.memory_time;
  fastest_ = settings.max_speed;
  fastest_turn_ = settings.max_turn;
}

void GuardMemory::forget() {
  out_of_sight_.forget();
  recalled_.reset();
  jumped_.reset();
  told_since_.reset();
  strayed_.reset();
}

/// As of the latest look that somebody knows the place of.
std::string GuardMemory::remembered() const {
  if (recalled_) return to_text(*recalled_);
  if (!by_odometry_ || !latest_) return {};
  const Whereabouts& robot = latest_->robot;
  const Whereabouts there{robot.pose, {}, robot.drift, robot.unexplained};
  std::vector<std::string> names;
  for (const SensorSettings& sensor : sensors_) names.push_back(written_name(sensor));
  return to_text({latest_->stamp, robot.pose, out_of_sight_.placed(there, latest_->at), names});
}

bool GuardMemory::recall(const std::string& remembered) {
  auto kept = kept_places_in(remembered);
  if (!kept) return remembered.empty();
  recalled_ = std::move(kept);
  return true;
}

bool GuardMemory::may_have_gone(const Pose2& way, double seconds) const {
  const double time = std::max(0.0, seconds);
  return length_of(way.place) <= fastest_ * time + least_jump &&
         std::abs(way.heading) <= fastest_turn_ * time + least_jump;
}

/// Odometry that began anew meanwhile has jumped.
void GuardMemory::place_recalled(double stamp, const Whereabouts& robot, const Went& went, const Instant& now) {
  Pose2 then = recalled_->robot;  // each process counts its own full turns
  then.heading = robot.pose.heading + wrapped(then.heading - robot.pose.heading);
  if (may_have_gone(between(then, robot.pose), stamp - recalled_->stamp)) {
    out_of_sight_.recall(in_order_of(sensors_, *recalled_), {then, {}, robot.drift, robot.unexplained}, now.steady);
  } else {
    jumped_ = looks_since(went, now);
  }
  recalled_.reset();
}

/// The base's clock may be ahead of all the others.
double GuardMemory::looks_since(const Went& went, const Instant& now) {
  return std::min(went.odometry.goes_on_since(), now.ros);
}

/// Who waits already has nothing placed that another break could displace.
bool GuardMemory::note_breaks(const Went& went, const Instant& now) {
  if (went.odometry.breaks() == breaks_) return false;
  if (by_odometry_ && out_of_sight_.holds_any(now.steady)) jumped_ = looks_since(went, now);
  breaks_ = went.odometry.breaks();
  if (by_odometry_) go_on_as_told(now);
  return true;
}

/// Until odometry speaks again, in whichever frame that is then.
void GuardMemory::go_on_as_told(const Instant& now) {
  if (latest_) {
    out_of_sight_.go_on_in_frame(latest_->robot, latest_->as_told, now.steady);
  } else {
    out_of_sight_.forget();
  }
  by_odometry_ = false;
  told_since_ = now.steady;
  latest_.reset();
}

/// A base that nobody tells anything stands sooner or later, or goes on for ever.
void GuardMemory::note_deafness(double seconds, const Given& given, const Instant& now) {
  const Pose2 way = way_of(given.told_at(now.steady), seconds);
  if (displacement(way, 1.0) > well_known && out_of_sight_.has_seen_any(now.steady)) strayed_ = now.steady;
}

/// What was remembered then.
bool GuardMemory::has_strayed(const Instant& now) const {
  return !by_odometry_ && strayed_ && now.steady - *strayed_ <= time_;
}

std::optional<Pose2> GuardMemory::note(std::size_t sensor, const Look& look, const Went& went, const Instant& now) {
  choose_whereabouts(look.stamp, went, now);
  const double came_after = now.ros - look.stamp;  // [s]
  const auto robot = whereabouts_at(came_after, went, now);
  if (robot) {
    if (recalled_ && by_odometry_ && !are_over(recalled_->stamp, now.ros, time_))
      place_recalled(look.stamp, *robot, went, now);
    const auto as_told = went.given.whereabouts_at(now.steady - came_after);
    latest_ = Latest{look.stamp, now.steady, *robot, as_told};
    out_of_sight_.note(sensor, look, *robot, now.steady, came_after, way_during(look, went, now));
  } else {
    out_of_sight_.note_unplaced(sensor, now.steady);
  }
  return by_odometry_ && robot ? std::optional(robot->pose) : std::nullopt;
}

/// None of what is taken at once. Some stamp a scan when it ends.
Pose2 GuardMemory::way_during(const Look& look, const Went& went, const Instant& now) const {
  if (look.lasts == 0.0) return {};
  const double begun = std::max(now.ros - look.stamp, look.lasts);  // [s] ago
  const auto first = whereabouts_at(begun, went, now), last = whereabouts_at(begun - look.lasts, went, now);
  return first && last ? between(first->pose, last->pose) : Pose2{};
}

/// By odometry once it goes on, with what was remembered until then, placed by it too as far back as it goes; if it
/// falls silent, by what the base is told, but not what it was to place.
void GuardMemory::choose_whereabouts(double stamp, const Went& went, const Instant& now) {
  const Odometry& odometry = went.odometry;
  const bool is_fresh = by_odometry_ ? odometry.is_fresh(now.ros) : odometry.stays_fresh(now.ros);
  const bool goes_on = is_fresh && odometry.goes_on_for() >= begins_after;
  const bool speaks = goes_on && odometry.pose_at(stamp);
  const bool holds_any = out_of_sight_.holds_any(now.steady);
  if (speaks == by_odometry_ || (by_odometry_ && holds_any)) return;
  by_odometry_ = speaks;
  told_since_.reset();
  latest_.reset();
  if (const auto there = by_odometry_at(now.ros, went, now); holds_any && there) {
    const auto was_at = [&](double look) { return by_odometry_at(look, went, now); };
    out_of_sight_.go_on_in_frame(went.given.whereabouts_at(now.steady), *there, now.steady, was_at);
  } else {
    out_of_sight_.forget();
  }
}

/// `age` [s] ago.
std::optional<Whereabouts> GuardMemory::whereabouts_at(double age, const Went& went, const Instant& now) const {
  if (!by_odometry_) return went.given.whereabouts_at(now.steady - age);
  return by_odometry_at(now.ros - age, went, now);
}

std::optional<Whereabouts> GuardMemory::by_odometry_at(double stamp, const Went& went, const Instant& now) const {
  const auto pose = by_odometry_ ? went.odometry.pose_at(stamp) : std::nullopt;
  if (!pose) return std::nullopt;
  return Whereabouts{*pose, {}, odometry_drift_, went.odometry.unexplained_until(stamp), foretold_at(stamp, went, now)};
}

/// Beyond what odometry has told so far it goes on by its latest twist, and the base by all that it was told meanwhile:
/// who begins to turn, or ends, is elsewhere by then.
Drift GuardMemory::foretold_at(double stamp, const Went& went, const Instant& now) {
  const double told = went.odometry.spoke_until();
  if (!(stamp - told > soon)) return {};
  const auto by_command = [&](double moment) { return went.given.whereabouts_at(now.steady - (now.ros - moment)); };
  const Pose2 way = between(*went.odometry.pose_at(told), *went.odometry.pose_at(stamp));
  const Whereabouts before = by_command(told), there = by_command(stamp);
  Drift most;
  for (std::size_t i = 0; i < there.or_else.size(); ++i) {
    const Pose2 off = between(way, between(before.or_else[i], there.or_else[i]));
    most = {std::max(most.place, length_of(off.place)), std::max(most.heading, std::abs(off.heading))};
  }
  return most;
}

std::vector<KnownPlace> GuardMemory::resting(const Outlook& sensor, const Whereabouts& robot,
                                             const Instant& now) const {
  return out_of_sight_.resting(sensor, robot, now.steady);
}

/// Not every sensor that is required has looked since odometry goes on. What was to be placed then is forgotten by and
/// by.
bool GuardMemory::waits_for(const std::vector<GuardSensor>& sensors, const Instant& now) const {
  return jumped_ && !(now.ros - *jumped_ > time_) &&
         std::any_of(sensors.begin(), sensors.end(), [this](const GuardSensor& sensor) {
           return sensor.is_required() && !sensor.has_looked_since(*jumped_);
         });
}

/// Why what is out of sight cannot be placed.
std::optional<Doubt> GuardMemory::doubt_at(const Instant& now, const Went& went,
                                           const std::vector<GuardSensor>& sensors) const {
  const auto in_doubt = [](const char* reason) { return Doubt{Cause::NoOdometry, reason}; };
  const bool is_placed_by_odometry = by_odometry_ && out_of_sight_.holds_any(now.steady);
  if (is_placed_by_odometry && went.odometry.breaks() != breaks_)
    return in_doubt("odometry jumped or paused, and what is out of sight cannot be placed");
  if (has_strayed(now))
    return in_doubt("this node stood still as the robot drove, and what is out of sight cannot be placed");
  if (recalled_) return in_doubt("no odometry, and what was out of sight before this start cannot be placed");
  if (waits_for(sensors, now)) return in_doubt("odometry jumped or paused, and not every sensor has looked since");
  if (is_placed_by_odometry && !(went.odometry.is_fresh(now.ros) && went.odometry.pose_at(now.ros)))
    return in_doubt("no odometry, and what is out of sight cannot be placed");
  return std::nullopt;
}

std::vector<Known> GuardMemory::known_at(const Instant& now, const Went& went, const std::vector<GuardSensor>& sensors,
                                         const std::vector<bool>& shows, const Guard& guard) {
  if (recalled_ && (are_over(recalled_->stamp, now.ros, time_) || !remembers())) recalled_.reset();
  Known known;
  known.sensor = "memory";
  known.doubt = doubt_at(now, went, sensors);
  if (has_strayed(now)) known.hint = what_frees_who_strayed;
  if (known.doubt) return {known};
  jumped_.reset();
  if (!out_of_sight_.holds_any(now.steady)) return {};
  const Whereabouts robot = *whereabouts_at(0.0, went, now);  // there is, or it would be in doubt
  known.law = sensors.front().law();
  known.law.min_points = 1;
  known.hint = what_frees;
  known.ways = {Pose2{}};
  const double reach = guard.reach(0.0, known.law);
  rings_.clear();
  std::vector<Known> all;
  const auto add = [&](std::vector<Ring> rings) {
    // What the margin is kept for: half of it for where things are, the rest for what the robot does. What decides is
    // the nearest of many returns, not one of min_points as in a picture, and lies nearer than the thing by the noise.
    for (Ring& ring : rings)
      ring.obstacles.widening = std::max(-known.law.noise, ring.obstacles.widening - 0.5 * margin_);
    rings_.push_back(std::move(rings));
    known.rings = &rings_.back();
    all.push_back(known);
  };
  if (by_odometry_) {
    add(out_of_sight_.rings(robot, reach, now.steady, shows));
    return all;
  }
  const bool was_placed = told_since_ && now.steady - *told_since_ <= time_;  // well, by odometry: all of it counts
  known.is_reckoned = !was_placed;
  const auto is_missed = [&](std::size_t sensor, const Point2& place, const Heights& heights, double off) {
    return shows[sensor] && !was_placed && sensors[sensor].misses(place, heights, off);
  };
  auto of_each = out_of_sight_.rings_of_each(robot, reach, now.steady, shows, is_missed);
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    known.seen_by = shows[i] ? sensors[i].eye() : std::nullopt;
    known.is_missed = false;
    add(std::move(of_each[i].all));
    known.is_missed = true;
    add(std::move(of_each[i].asked_for));
  }
  return all;
}

}  // namespace safety_control_cloud
