// SPDX-License-Identifier: BSD-3-Clause
#include "safety_control.hpp"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "look/passthrough.hpp"

namespace safety_control_cloud {
namespace {

/// [s] by which ROS time may go back without a stop: clocks of computers are set right in such small steps.
constexpr double clock_slack = 0.1;

std::string measured(double value, const char* unit) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << value << " " << unit;
  return text.str();
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const auto& sentence : sentences) text += (text.empty() ? "" : "; ") + sentence;
  return text;
}

Settings checked(const Settings& settings) {
  const auto problems = problems_in(settings);
  if (!problems.empty()) throw std::invalid_argument(joined(problems));
  return settings;
}

Sight look_by(Method method, const View& view, const Corridor& corridor, const Gaze& gaze) {
  return method == Method::Pcl ? passthrough(view, corridor, gaze) : look(view, corridor, gaze);
}

/// Few returns are no proof of free space.
bool is_blind(const Sight& sight, double min_valid_ratio) {
  if (sight.returns == 0) return true;
  return static_cast<double>(sight.returns) < min_valid_ratio * static_cast<double>(sight.total);
}

Zone zone_of(const Loss& loss, const ZoneLimits& limits) {
  return loss.whole || !loss.obstacle ? Zone::Danger : zone_at(loss.obstacle->distance(), limits);
}

}  // namespace

SafetyControl::SafetyControl(const Settings& settings)
    : settings_(checked(settings)),
      corridor_(corridor_of(settings_)),
      latch_(settings_.release),
      near_loss_(settings_.near_loss) {
  last_.reason = "no cloud has arrived yet";
}

void SafetyControl::take(const Settings& settings) {
  settings_ = checked(settings);
  corridor_ = corridor_of(settings_);
  latch_.hold(settings_.release);
  near_loss_.limit(settings_.near_loss);
}

Decision SafetyControl::decide(const Reading& reading, const Origin& origin, const Instant& now, Crop crop) {
  const bool ambiguous = sources_.others_beside(origin.source, now.steady, settings_.source_timeout);
  last_arrival_ = now.steady;
  if (ambiguous) return stop(Cause::TwoSources, "clouds of two publishers arrive in turn", now.steady);
  if (const auto doubt = doubt_before_looking(reading, origin, now)) return *doubt;

  const View view = view_in(reading);
  Gaze gaze;
  gaze.crop = crop;
  gaze.placement = std::get_if<Placement>(&origin.placing);
  gaze.memory = near_loss_.memory_for(view);
  const Sight sight = look_by(settings_.method, view, corridor_, gaze);

  if (const auto doubt = doubt_about(sight, view, origin.stamp, now.steady)) return *doubt;
  const auto loss = near_loss_.judge(view, sight, corridor_, gaze, now.steady);
  return decide_by(sight, loss, now.steady);
}

std::optional<Decision> SafetyControl::doubt_before_looking(const Reading& reading, const Origin& origin,
                                                            const Instant& now) {
  if (clock_went_back(now.ros)) return stop(Cause::ClockJump, "ROS time went backwards", now.steady);
  if (const auto* unreadable = std::get_if<Unreadable>(&reading)) {
    return stop(Cause::Unreadable, unreadable->reason, now.steady);
  }
  const double age = now.ros - origin.stamp, tolerance = settings_.stamp_tolerance;
  if (tolerance > 0.0 && !(age <= tolerance)) {
    return stop(Cause::Stale, "the cloud's stamp is " + measured(age, "s") + " old", now.steady);
  }
  if (tolerance > 0.0 && !(age >= -tolerance)) {
    return stop(Cause::Future, "the cloud's stamp is " + measured(-age, "s") + " ahead", now.steady);
  }
  if (const auto* missing = std::get_if<NoTransform>(&origin.placing)) {
    return stop(Cause::NoTransform, missing->reason, now.steady);
  }
  return std::nullopt;
}

std::optional<Decision> SafetyControl::doubt_about(const Sight& sight, const View& view, double stamp, double now) {
  if (is_blind(sight, settings_.min_valid_ratio)) {
    stop(Cause::Blind, std::to_string(sight.returns) + " returns of " + std::to_string(sight.total) + " points", now);
    last_.sight = sight;
    return last_;
  }
  if (settings_.frozen_clouds == 0) return std::nullopt;
  const std::size_t same = frozen_.count(view, stamp);
  if (same < settings_.frozen_clouds) return std::nullopt;
  stop(Cause::Frozen, std::to_string(same) + " successive clouds have the same content", now);
  last_.sight = sight;
  return last_;
}

Decision SafetyControl::decide_by(const Sight& sight, const std::optional<Loss>& loss, double now) {
  const Zone seen = sight.nearest ? zone_at(sight.nearest->distance(), settings_.limits) : Zone::Safe;
  const Zone lost = loss ? zone_of(*loss, settings_.limits) : Zone::Safe;
  last_.zone = latch_.update(std::min(seen, lost), now);
  last_.speed = speed_for(last_.zone, settings_.speeds);
  last_.sight = sight;
  if (lost < seen) {
    last_.cause = loss->cause;
    last_.reason = loss->reason;
    last_.nearest = loss->obstacle;
  } else {
    last_.cause = Cause::Seen;
    last_.reason =
        sight.nearest ? "nearest obstacle at " + measured(sight.nearest->distance(), "m") : "corridor is free";
    last_.nearest = sight.nearest;
  }
  return last_;
}

Decision SafetyControl::without_cloud(const Instant& now) {
  if (clock_went_back(now.ros)) return stop(Cause::ClockJump, "ROS time went backwards", now.steady);
  if (last_arrival_ && now.steady - *last_arrival_ > settings_.source_timeout) {
    return stop(Cause::Silent, "no cloud for " + measured(now.steady - *last_arrival_, "s"), now.steady);
  }
  return last_;
}

bool SafetyControl::clock_went_back(double ros_now) {
  const bool back = last_ros_ && ros_now < *last_ros_ - clock_slack;
  last_ros_ = ros_now;
  return back;
}

Decision SafetyControl::stop(Cause cause, std::string reason, double now) {
  last_ = Decision{};
  last_.zone = latch_.update(Zone::Danger, now);
  last_.cause = cause;
  last_.reason = std::move(reason);
  return last_;
}

}  // namespace safety_control_cloud
