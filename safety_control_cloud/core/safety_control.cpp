// SPDX-License-Identifier: BSD-3-Clause
#include "safety_control.hpp"

#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "passthrough.hpp"

namespace safety_control_cloud {
namespace {

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

Sight look_by(Method method, const CloudView& cloud, const Corridor& corridor, Crop crop) {
  return method == Method::Pcl ? passthrough(cloud, corridor, crop) : look(cloud, corridor, crop);
}

/// Few returns are no proof of free space.
bool is_blind(const Sight& sight, double min_valid_ratio) {
  if (sight.returns == 0) return true;
  return static_cast<double>(sight.returns) < min_valid_ratio * static_cast<double>(sight.total);
}

}  // namespace

const char* name_of(Cause cause) {
  switch (cause) {
    case Cause::Seen:
      return "SEEN";
    case Cause::NoCloud:
      return "NO_CLOUD";
    case Cause::Silent:
      return "SILENT";
    case Cause::Unreadable:
      return "UNREADABLE";
    case Cause::Blind:
      return "BLIND";
  }
  return "UNKNOWN";
}

SafetyControl::SafetyControl(const Settings& settings) : settings_(checked(settings)), latch_(settings_.release) {
  last_.reason = "no cloud has arrived yet";
}

Decision SafetyControl::decide(const Reading& cloud, double now, Crop crop) {
  last_arrival_ = now;
  if (const auto* unreadable = std::get_if<Unreadable>(&cloud)) {
    return stop(Cause::Unreadable, unreadable->reason, now);
  }
  return decide_by(look_by(settings_.method, std::get<CloudView>(cloud), settings_.corridor, crop), now);
}

Decision SafetyControl::decide_by(const Sight& sight, double now) {
  if (is_blind(sight, settings_.min_valid_ratio)) {
    stop(Cause::Blind, std::to_string(sight.returns) + " returns of " + std::to_string(sight.total) + " points", now);
    last_.sight = sight;
    return last_;
  }
  const Zone seen = sight.nearest ? zone_at(sight.nearest->distance(), settings_.limits) : Zone::Safe;
  last_.zone = latch_.update(seen, now);
  last_.speed = speed_for(last_.zone, settings_.speeds);
  last_.cause = Cause::Seen;
  last_.reason = sight.nearest ? "nearest obstacle at " + measured(sight.nearest->distance(), "m") : "corridor is free";
  last_.nearest = sight.nearest;
  last_.sight = sight;
  return last_;
}

Decision SafetyControl::without_cloud(double now) {
  if (last_arrival_ && now - *last_arrival_ > settings_.source_timeout) {
    return stop(Cause::Silent, "no cloud for " + measured(now - *last_arrival_, "s"), now);
  }
  return last_;
}

Decision SafetyControl::stop(Cause cause, std::string reason, double now) {
  last_ = Decision{};
  last_.zone = latch_.update(Zone::Danger, now);
  last_.cause = cause;
  last_.reason = std::move(reason);
  return last_;
}

}  // namespace safety_control_cloud
