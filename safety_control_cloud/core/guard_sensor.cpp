// SPDX-License-Identifier: BSD-3-Clause
#include "guard_sensor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "input/angle.hpp"
#include "look/outlook.hpp"
#include "text/reader.hpp"
#include "text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double turned_away = 0.2;  ///< [rad] by which a camera may look past its corridor before that follows it

constexpr const char* facing_word = "facing";
constexpr double least_of_scan = 0.3;      ///< [m] from which on a laser measures what is there, if it does so near
constexpr double beyond_range_min = 0.05;  ///< [m] from which on it does, if not
constexpr double least_beyond = 0.15;      ///< [m] beyond its blind range from which on a camera does

Surroundings surroundings_of(const Settings& own, const Guard& guard) {
  const FrameCorridor& band = own.frame_corridor;
  return {guard.outline(), {band.bottom, band.top, guard.reach(own.source_timeout, law_of(own)), own_boxes_of(own)}};
}

Bearings bearings_of(const Settings& own) {
  return Bearings(own_boxes_of(own), own.zero_is_inf ? Bearings::Zero::WhatInfSays : Bearings::Zero::Nothing);
}

}  // namespace

GuardSensor::GuardSensor(const SensorSettings& sensor, const Settings& settings, const Guard& guard)
    : about_(sensor),
      own_(own_settings(settings, sensor)),
      straight_(sensor_settings(own_)),
      law_(law_of(own_)),
      sensor_(straight_),
      around_(surroundings_of(own_, guard)),
      bearings_(bearings_of(own_)) {}

void GuardSensor::adopt(const Settings& settings, const Guard& guard) {
  own_ = own_settings(settings, about_);
  straight_ = sensor_settings(own_);
  law_ = law_of(own_);
  sensor_.adopt(sensor_settings(own_, facing_));
  around_ = surroundings_of(own_, guard);
  bearings_ = bearings_of(own_);
  lost_.forget_explanation();
  collected_ = Collected::Nothing;  // what was, was collected within other limits
}

std::optional<Look> GuardSensor::see(const Reading& reading, const Origin& origin, const Instant& now,
                                     const Given& given) {
  last_arrival_ = now.steady;
  last_taken_ = taken_at(origin, now);
  if (taken_ && collected_ == Collected::Nothing) collected_ = Collected::Before;
  face(reading, origin.placing);
  Origin facing = origin;
  if (const auto* placement = std::get_if<Placement>(&origin.placing))
    facing.placing = in_turned_frame(*placement, facing_);
  const auto outlook = outlook_of(straight_, origin.placing);
  const auto* placed = std::get_if<Outlook>(&outlook);
  const auto alongside = placed ? std::optional(around_.begin(*placed)) : std::nullopt;
  const std::uint32_t before = sensor_.picture();
  sensor_.see(reading, facing, now, Crop::Skip, alongside ? &*alongside : nullptr);
  is_new_picture_ = sensor_.picture() != before;
  if (sensor_.repeats()) return std::nullopt;
  lost_.note(sensor_.answer(), sensor_.is_any_near());
  if (std::holds_alternative<Doubt>(sensor_.answer())) return std::nullopt;
  const Outlook upright = sensor_.upright(std::get<Outlook>(outlook));  // there is, or nothing were seen
  return take(reading, origin, upright, now, given);
}

void GuardSensor::forget_losses() {
  sensor_.forget_losses();
  lost_.forget();
  looked_over_.forget();
}

/// After which way its corridor leads, if that is not ahead.
std::string GuardSensor::remembered() const {
  const std::string& text = sensor_.remembered();
  return text.empty() || facing_ == 0.0 ? text : words(facing_word, ' ', facing_, ' ', text);
}

/// What it tells of was lost in a corridor that led so, and stays so until the sensor has seen more.
bool GuardSensor::recall(const std::string& remembered) {
  if (own_.input == InputKind::Scan) return remembered.empty();
  Reader reader(remembered);
  const bool is_turned = reader.word() == facing_word;
  const double facing = is_turned ? reader.number(-pi, pi) : 0.0;
  const std::string text = is_turned ? reader.rest() : remembered;
  if (!reader.good() || (is_turned && text.empty()) || !sensor_.recall(text)) return false;
  lost_.note_recalled(sensor_.is_recalled());
  if (!sensor_.is_recalled()) return true;
  sensor_.adopt(sensor_settings(own_, facing));
  facing_ = facing;
  return true;
}

/// Who looks to all sides looks ahead too. A camera that turns away from what it lost would see something behind that
/// wherever it looks, if its corridor turned too.
void GuardSensor::face(const Reading& reading, const Placing& placing) {
  const auto* placement = std::get_if<Placement>(&placing);
  if (!placement || lost_.is_ahead()) return;
  const Outlook outlook({}, *placement);
  const auto* scan = std::get_if<ScanView>(&reading);
  const Eye eye = scan ? eye_of(outlook, *scan, {}) : eye_of(outlook, FieldOfView{});
  const Point2 ahead = eye.half_angle >= pi ? Point2{1.0, 0.0} : eye.direction;
  if (length_of(ahead) == 0.0) return;  // straight up or down
  const double heading = std::atan2(ahead.y, ahead.x);
  if (std::abs(wrapped(heading - facing_)) <= turned_away) return;
  const double before = std::exchange(facing_, std::abs(heading) <= turned_away ? 0.0 : heading);
  sensor_.turn_corridor(sensor_settings(own_, facing_), facing_ - before);
}

Look GuardSensor::take(const Reading& reading, const Origin& origin, const Outlook& outlook, const Instant& now,
                       const Given& given) {
  const View& view = sensor_.upright_view();
  around_.finish();
  collected_ = Collected::Now;
  ++looks_;
  if (const auto* scan = std::get_if<ScanView>(&reading)) bearings_.note(*scan, outlook, now.steady);
  const Heights heights{own_.frame_corridor.bottom, own_.frame_corridor.top};
  taken_.emplace(reading, view, outlook, heights, bearings_);
  taken_->arrival = now;
  taken_->time_to_arrive = now.ros - taken_at(origin, now);
  taken_->from = given.reckoned_at(now.steady - taken_->time_to_arrive);
  const double measures_from = taken_->is_scan ? std::max(least_of_scan, taken_->range_min + beyond_range_min)
                                               : own_.near_loss.blind_range + least_beyond;
  return {reading, view, outlook, taken_->stamp(), measures_from, taken_->may_last(), looks_, &bearings_};
}

double GuardSensor::taken_at(const Origin& origin, const Instant& now) const {
  return own_.stamp_tolerance > 0.0 ? std::min(origin.stamp, now.ros) : now.ros;
}

bool GuardSensor::note_pose(const std::optional<Pose2>& pose, double now) {
  const bool is_any_lost = lost_.note_pose(sensor_.answer(), pose, now);
  if (pose) note_picture_from(taken_->outlook, *pose, now);
  return is_any_lost;
}

void GuardSensor::note_picture_from(const Outlook& outlook, const Pose2& pose, double now) {
  if (is_new_picture_) lost_.note_picture(sensor_.picture(), {outlook, pose, now});
}

void GuardSensor::explain_loss(const std::vector<KnownPlace>& known, double now) {
  lost_.explain(sensor_.answer(), known, *taken_, own_.near_loss.blind_range, own_.memory_time, now);
}

/// In base_frame [m].
std::vector<Point2> GuardSensor::ends_below() const {
  std::vector<Point2> ends;
  for (const Point& end : sensor_.ends_below()) {
    const Point placed = taken_->outlook.placed(end.x, end.y, end.z);
    ends.push_back({placed.z, -placed.x});
  }
  return ends;
}

void GuardSensor::note_fronts(const std::vector<KnownPlace>& known, double now) {
  looked_over_.note(ends_below(), taken_->eye.place, known, now);
}

std::optional<Outlook> GuardSensor::outlook_if_blind(const Placing& placing) const {
  const auto* placement = std::get_if<Placement>(&placing);
  if (!lost_.is_blind_only(sensor_.answer()) || own_.input == InputKind::Scan || !taken_ || !placement)
    return std::nullopt;
  return sensor_.upright(Outlook({}, *placement));
}

void GuardSensor::explain_blindness(const std::vector<KnownPlace>& known, double now) {
  lost_.explain_blindness(sensor_.counted(), known, taken_->field, own_.near_loss.blind_range, own_.memory_time, now);
}

void GuardSensor::wait(const Instant& now) {
  sensor_.wait(now);
  lost_.note_silence(sensor_.answer());
}

}  // namespace safety_control_cloud
