// SPDX-License-Identifier: BSD-3-Clause
#include "guard_memory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "guard/recalled_places.hpp"

namespace safety_control_cloud {
namespace {

constexpr double begins_after = 0.2;  ///< [s] that odometry must go on before it is asked
constexpr double soon = 0.05;         ///< [s] in which no base comes to move much otherwise

}  // namespace

GuardMemory::Limits::Limits(const Settings& settings)
    : places{{settings.frame_corridor.bottom, settings.frame_corridor.top, settings.memory_distance,
              own_boxes_of(settings)},
             settings.memory_time,
             settings.obstacle_speed},
      sensors(sensors_of(settings)),
      odometry_drift(settings.odometry_drift),
      margin(settings.margin),
      fastest{settings.max_speed, 0.0, settings.max_turn} {}

GuardMemory::GuardMemory(const Settings& settings)
    : limits_(settings), out_of_sight_(limits_.places), check_(limits_.places.time) {}

void GuardMemory::adopt(const Settings& settings) {
  limits_ = Limits(settings);
  out_of_sight_.limit(limits_.places);
  check_.keep_for(limits_.places.time);
}

void GuardMemory::forget() {
  out_of_sight_.forget();
  recalled_.reset();
  broke_off_.reset();
  jumped_.reset();
  told_since_.reset();
  strayed_.reset();
  mistaken_.reset();
  check_.forget();
}

/// As of the latest look that somebody knows the place of.
std::string GuardMemory::remembered() const {
  if (recalled_) return to_text(*recalled_);
  if (mistaken_) return to_text({*mistaken_, std::nullopt, {}});
  if (const auto placed = to_keep()) return to_text(*placed);
  return broke_off_ ? to_text(*broke_off_) : std::string();
}

std::optional<KeptPlaces> GuardMemory::to_keep() const {
  if (!by_odometry_ || !latest_) return std::nullopt;
  const Whereabouts& robot = latest_->robot;
  const Whereabouts there{robot.pose, {}, robot.drift, robot.unexplained};
  return KeptPlaces{latest_->stamp, robot.pose, out_of_sight_.placed(there, latest_->at),
                    written_names(limits_.sensors)};
}

bool GuardMemory::recall(const std::string& remembered) {
  auto kept = kept_places_in(remembered);
  if (!kept) return remembered.empty();
  recalled_ = std::move(kept);
  return true;
}

/// Odometry that began anew meanwhile has jumped. What it was known to have jumped from waits until its time is over:
/// it may lie right beside the robot.
void GuardMemory::place_recalled(double stamp, const Whereabouts& robot, const Went& went, const Instant& now) {
  if (!recalled_->robot) return;
  if (const auto then = seen_from(*recalled_, robot.pose, stamp, limits_.fastest)) {
    const auto places = shown_by(limits_.sensors, *recalled_);
    out_of_sight_.recall(places, {*then, {}, robot.drift, robot.unexplained}, now.steady);
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
  const bool has_jumped = went.odometry.jumps() != jumps_;
  const bool is_proven_wrong = by_odometry_ && has_jumped && check_.note_jump(now);
  if (is_proven_wrong && out_of_sight_.has_seen_any(now.steady)) check_.note_that_something_was_near();
  breaks_ = went.odometry.breaks(), jumps_ = went.odometry.jumps();
  if (by_odometry_) go_on_as_told(now);
  for (auto* kept : {&recalled_, &broke_off_})
    if (has_jumped && *kept) (*kept)->robot.reset();  // odometry goes on in another frame, for all that is known
  return true;
}

/// Until odometry speaks again, in whichever frame that is then.
void GuardMemory::go_on_as_told(const Instant& now) {
  if (auto placed = to_keep(); placed && !placed->all.empty()) broke_off_ = std::move(placed);
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
  return !by_odometry_ && strayed_ && now.steady - *strayed_ <= limits_.places.time;
}

/// For as long as what was near then may be there.
bool GuardMemory::is_mistaken(const Instant& now) const {
  return has_strayed(now) || check_.contradiction_at(now.steady).has_value();
}

std::optional<Pose2> GuardMemory::note(std::size_t sensor, const Look& look, const Went& went, const Instant& now) {
  choose_whereabouts(look.stamp, went, now);
  const bool is_compared = check_.note_look(by_odometry_ ? &went.odometry : nullptr, went.given, now);
  if (is_compared && check_.has_contradicted() && out_of_sight_.has_seen_any(now.steady))
    check_.note_that_something_was_near();
  const double came_after = now.ros - look.stamp;  // [s]
  const auto robot = whereabouts_at(came_after, went, now);
  if (robot) {
    if (recalled_ && by_odometry_ && !are_over(recalled_->stamp, now.ros, limits_.places.time))
      place_recalled(look.stamp, *robot, went, now);
    const auto as_told = went.given.whereabouts_at(now.steady - came_after);
    latest_ = Latest{look.stamp, now.steady, *robot, as_told};
    if (by_odometry_) broke_off_.reset();
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
  return Whereabouts{
      *pose, {}, limits_.odometry_drift, went.odometry.unexplained_until(stamp), foretold_at(stamp, went, now)};
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

std::vector<KnownPlace> GuardMemory::resting(const Look& look, const Went& went, const Instant& now) const {
  const auto robot = whereabouts_at(now.ros - look.stamp, went, now);
  return robot ? resting(look.outlook, *robot, now) : std::vector<KnownPlace>();
}

std::vector<KnownPlace> GuardMemory::resting(const Outlook& sensor, const Whereabouts& robot,
                                             const Instant& now) const {
  return out_of_sight_.resting(sensor, robot, now.steady);
}

}  // namespace safety_control_cloud
