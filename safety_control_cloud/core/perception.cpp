// SPDX-License-Identifier: BSD-3-Clause
#include "perception.hpp"

#include <algorithm>
#include <iterator>

#include "guard/override.hpp"
#include "text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr char after_name = '\n';  // before what a sensor remembers

std::string named(const std::string& name, const std::string& text) {
  return text.empty() || name.empty() ? text : name + after_name + text;
}

std::vector<GuardSensor> sensors_by(const Settings& settings, const Guard& guard) {
  std::vector<GuardSensor> sensors;
  for (const SensorSettings& sensor : sensors_of(settings)) sensors.emplace_back(sensor, settings, guard);
  return sensors;
}

}  // namespace

Perception::Perception(const Settings& settings, const Guard& guard)
    : settings_(settings), sensors_(sensors_by(settings, guard)), closed_(settings.switches), memory_(settings) {}

void Perception::adopt(const Settings& settings, const Guard& guard) {
  const bool same = sensors_of(settings) == sensors_of(settings_);
  if (!(settings.switches == settings_.switches)) closed_ = ClosedEdges(settings.switches);
  settings_ = settings;
  if (!same) {
    sensors_ = sensors_by(settings_, guard);
    memory_.forget();
  }
  for (GuardSensor& sensor : sensors_) sensor.adopt(settings_, guard);
  memory_.adopt(settings_);
}

void Perception::forget_losses() {
  memory_.forget();
  unplaced_.forget();
  closed_.reset();
  for (GuardSensor& sensor : sensors_) sensor.forget_losses();
}

std::vector<std::string> Perception::remembered() const {
  std::vector<std::string> texts;
  for (const GuardSensor& sensor : sensors_) texts.push_back(named(name_before_losses(sensor), sensor.remembered()));
  for (const std::string& text : unplaced_.texts()) texts.push_back(text);
  texts.push_back(memory_.remembered());
  if (auto touched = closed_.remembered(); !touched.empty()) texts.push_back(std::move(touched));
  return texts;
}

bool Perception::recall(const std::vector<std::string>& remembered) {
  unplaced_.forget();
  for (const std::string& line : remembered)
    if (!line.empty() && !go_on_with(line)) unplaced_.note(line);
  return !unplaced_.any();
}

std::string Perception::name_before_losses(const GuardSensor& sensor) const {
  return settings_.sensors.empty() ? "" : sensor.name();
}

/// Who goes on with a line already, does not take another one in its place.
bool Perception::go_on_with(const std::string& line) {
  if (memory_.remembered().empty() && memory_.recall(line)) return true;
  if (closed_.remembered().empty() && closed_.recall(line)) return true;
  const std::size_t end = line.find(after_name);
  const bool is_named = end != std::string::npos;
  const std::string name = is_named ? line.substr(0, end) : "";
  const auto is_its_own = [&](const GuardSensor& one) { return name_before_losses(one) == name; };
  const auto sensor = std::find_if(sensors_.begin(), sensors_.end(), is_its_own);
  return sensor != sensors_.end() && sensor->remembered().empty() &&
         sensor->recall(is_named ? line.substr(end + 1) : line);
}

double Perception::until_silent(double now) const {
  double soonest = closed_.until_silent(now);
  for (const GuardSensor& sensor : sensors_) soonest = std::min(soonest, sensor.until_silent(now));
  return soonest;
}

void Perception::see(const Reading& reading, const Origin& origin, const Instant& now, std::size_t sensor,
                     const Given& given) {
  const auto look = sensors_[sensor].see(reading, origin, now, given);
  const Went went{odometry_, given};
  if (memory_.note_breaks(went, now))
    for (GuardSensor& one : sensors_) one.forget_poses();
  if (!look) return explain_blindness(sensor, origin, now, given);
  const auto pose = memory_.note(sensor, *look, went, now);
  GuardSensor& sees = sensors_[sensor];
  const bool is_any_lost = sees.note_pose(pose, now.steady), may_explain = is_any_lost && pose && memory_.remembers();
  std::vector<KnownPlace> resting;
  if (may_explain || sees.looks_over_any()) resting = memory_.resting(*look, went, now);
  sees.note_fronts(resting, now.steady);
  if (may_explain) sees.explain_loss(resting, now.steady);
}

void Perception::explain_blindness(std::size_t sensor, const Origin& origin, const Instant& now, const Given& given) {
  GuardSensor& blind = sensors_[sensor];
  const auto outlook = blind.outlook_if_blind(origin.placing);
  const auto robot = memory_.by_odometry_at(blind.taken_at(origin, now), {odometry_, given}, now);
  if (!outlook || !robot) return;
  blind.note_picture_from(*outlook, robot->pose, now.steady);
  blind.explain_blindness(memory_.resting(*outlook, *robot, now), now.steady);
}

void Perception::note_deafness(double seconds, const Instant& now, const Given& given) {
  odometry_.note_deafness(now.ros - seconds, now.ros);
  memory_.note_deafness(seconds, given, now);
}

/// A sensor that is not required, and in doubt, is as good as not there, but for what it has lost. After a change of
/// the settings each is awaited, required or not.
std::vector<Known> Perception::known_at(const Instant& now, const Given& given, const Guard& guard,
                                        std::vector<std::string>& doubts) {
  std::vector<Known> all, left;
  std::vector<bool> shows(sensors_.size(), false);
  if (const auto doubt = odometry_.doubt_at(now.ros)) doubts.push_back("odometry: " + *doubt);
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    GuardSensor& sensor = sensors_[i];
    sensor.wait(now);
    Known known = sensor.known_at(now, odometry_, given);
    const auto doubt = doubt_of(known);
    if (doubt && !sensor.is_required())
      doubts.push_back(words(sensor.name(), ": ", name_of(doubt->cause), ", ", doubt->reason));
    if (known.is_placed && !known.doubt)
      doubts.push_back(words(sensor.name(), ": ", name_of(known.lost->cause), ", before what is known to stand there"));
    const bool is_absent = known.doubt || (known.lost && known.lost->cause == Cause::Blind);
    if (is_absent && !sensor.is_required() && !sensor.is_awaited()) {
      if (auto behind = sensor.left_behind(known, now.steady)) left.push_back(*std::move(behind));
      continue;
    }
    if (outside_) known.doubt = outside_;
    shows[i] = sensor.shows() && !known.is_placed;
    all.push_back(std::move(known));
  }
  if (!all.empty()) {
    std::move(left.begin(), left.end(), std::back_inserter(all));
    for (Known& one : memory_.known_at(now, {odometry_, given}, sensors_, shows, guard)) all.push_back(std::move(one));
    for (Known& one : closed_.known_at(now.steady, settings_.switch_release_time)) all.push_back(std::move(one));
    if (auto unplaced = known_of_unplaced(now)) all.push_back(*std::move(unplaced));
    return all;
  }
  Known none;
  none.doubt = outside_ ? *outside_ : Doubt{Cause::NoCloud, "no sensor is required, and none to be believed"};
  return {none};
}

std::optional<Known> Perception::known_of_unplaced(const Instant& now) {
  unplaced_.forget_old(now, settings_);
  if (!unplaced_.any()) return std::nullopt;
  Known known;
  known.sensor = "memory";
  known.doubt = unplaced_.doubt();
  known.hint = Unplaced::hint;
  return known;
}

const Sight& Perception::sight_of(const std::string& sensor) const {
  const auto decided = [&](const GuardSensor& one) { return one.name() == sensor; };
  const auto found = std::find_if(sensors_.begin(), sensors_.end(), decided);
  return (found == sensors_.end() ? sensors_.front() : *found).counted();
}

}  // namespace safety_control_cloud
