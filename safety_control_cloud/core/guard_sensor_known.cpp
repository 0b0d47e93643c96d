// SPDX-License-Identifier: BSD-3-Clause
// What a guard's sensor lets one know.
#include <cmath>
#include <limits>
#include <utility>

#include "guard_sensor.hpp"
#include "memory/patience.hpp"
#include "speed/speed.hpp"
#include "verdict.hpp"

namespace safety_control_cloud {
namespace {

const std::vector<Ring> nothing;

constexpr const char* looked_over_hint =
    "its front is seen, or nothing of it for a second, or after ~reset, when somebody has looked";

/// Of what is ahead, as the drive mode has it.
std::optional<ZoneCap> cap_by(const Answer& answer, const Settings& settings, double facing) {
  const auto* seen = std::get_if<Seen>(&answer);
  if (!settings.zone_caps || !seen) return std::nullopt;
  const Zone zone = zone_of(seen->sight, settings.limits);
  return ZoneCap{zone, speed_for(zone, settings.speeds), {std::cos(facing), std::sin(facing)}};
}

}  // namespace

Known GuardSensor::known_at(const Instant& now, const Odometry& odometry, const Given& given) const {
  Known known;
  known.sensor = about_.name;
  known.law = law_;
  if (const auto* doubt = std::get_if<Doubt>(&sensor_.answer())) known.doubt = *doubt;
  if (auto lost = lost_.doubt(sensor_.answer(), own_.corridor.min_points)) {
    known.is_placed = lost_.is_explained() && lost->cause == Cause::Blind;
    known.lost = std::move(lost);
    if (const auto* seen = std::get_if<Seen>(&sensor_.answer()); seen && seen->loss) known.hint = seen->loss->hint;
    known.doubt.reset();
  } else if (!known.doubt && looked_over_.is_unknown()) {
    known.lost = Doubt{Cause::NearLoss, "it looks over something low, and nobody knows how near that reaches"};
    known.hint = looked_over_hint;
  }
  if (known.doubt && known.doubt->cause == Cause::WrongView && lost_.is_ahead())
    known.doubt->reason += "; it has turned away from where it lost something: let it look there again";
  if (outside_) known.doubt = outside_;
  const bool is_away_free =
      known.lost && (own_.input != InputKind::Scan || (own_.memory_distance > 0.0 && own_.memory_time > 0.0));
  if (collected_ == Collected::Nothing || (collected_ == Collected::Before && !is_away_free)) {
    if (!known.doubt) known.doubt = Doubt{Cause::NoCloud, "no cloud has been seen by these settings yet"};
    return known;
  }
  known.rings = known.is_placed ? &nothing : &around_.rings();  // or what it saw last is among the places that hide all
  known.age = {taken_->age_at(now), law_.sensor_period + taken_->time_to_arrive};
  known.ways = taken_->ways_since(now, odometry, given);
  known.eye = known.lost ? eye_on_what_is_lost() : taken_->eye;
  known.horizon = taken_->horizon;
  known.cap = cap_by(sensor_.answer(), own_, facing_);
  return known;
}

/// It may have turned away since.
Eye GuardSensor::eye_on_what_is_lost() const {
  Eye eye = taken_->eye;
  if (lost_.is_ahead()) eye.direction = {std::cos(facing_), std::sin(facing_)};
  return eye;
}

std::optional<Known> GuardSensor::left_behind(const Known& known, double now) const {
  const double since = last_arrival_ ? now - *last_arrival_ : 0.0;
  const bool is_forgotten = Patience{since, own_.near_loss.timeout}.ends(0.0);
  if (!lost_.has_any() || lost_.is_still_explained(now) || is_forgotten) return std::nullopt;
  if (!known.doubt) return known;
  Known left;
  left.sensor = about_.name;
  left.rings = &nothing;
  left.law = law_;
  left.ways = {Pose2{}};
  if (taken_) left.eye = eye_on_what_is_lost();
  left.lost = Doubt{Cause::NearLoss, "it had lost something from sight, and is in doubt: " + known.doubt->reason};
  left.hint = "it is believed again and sees what is behind that, or after ~reset, when somebody has looked";
  return left;
}

bool GuardSensor::misses(const Point2& place, const Heights& heights, double off) const {
  return taken_ && taken_->misses(place, heights, off);
}

bool GuardSensor::has_looked_since(double stamp) const {
  const bool is_blind = lost_.was_sound() && std::holds_alternative<Doubt>(sensor_.answer());
  return taken_ && (is_blind ? last_taken_ : taken_->stamp()) >= stamp;
}

double GuardSensor::until_silent(double now) const {
  const double left = last_arrival_ ? own_.source_timeout - (now - *last_arrival_) : 0.0;
  return left > 0.0 ? left : std::numeric_limits<double>::infinity();
}

}  // namespace safety_control_cloud
