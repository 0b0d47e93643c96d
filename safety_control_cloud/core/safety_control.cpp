// SPDX-License-Identifier: BSD-3-Clause
#include "safety_control.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include "speed/speed.hpp"
#include "verdict.hpp"

namespace safety_control_cloud {
namespace {

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

}  // namespace

SafetyControl::SafetyControl(const Settings& settings)
    : settings_(checked(settings)), sensors_{Sensor(settings_)}, latch_(settings_.release), last_(verdict()) {}

void SafetyControl::adopt(const Settings& settings) {
  settings_ = checked(settings);
  for (Sensor& sensor : sensors_) sensor.adopt(settings_);
  latch_.hold(settings_.release);
  worsen();
}

/// What was seen is worth less by other settings at once, and more with the next cloud.
void SafetyControl::worsen() {
  const double speed = last_.speed;
  if (Decision anew = verdict(); anew.zone < last_.zone) last_ = std::move(anew);
  last_.speed = std::min(speed, speed_for(last_.zone, settings_.speeds));
}

void SafetyControl::forget_losses() {
  unplaced_.forget();
  for (Sensor& sensor : sensors_) sensor.forget_losses();
}

std::vector<std::string> SafetyControl::remembered() const {
  std::vector<std::string> all;
  for (const Sensor& sensor : sensors_) all.push_back(sensor.remembered());
  for (const std::string& text : unplaced_.texts()) all.push_back(text);
  return all;
}

bool SafetyControl::recall(const std::vector<std::string>& remembered) {
  unplaced_.forget();
  Sensor& camera = sensors_.front();
  for (const std::string& text : remembered) {
    const bool is_its_own = camera.remembered().empty() && camera.recall(text);
    if (!text.empty() && !is_its_own) unplaced_.note(text);
  }
  return !unplaced_.any();
}

Decision SafetyControl::decide(const Reading& reading, const Origin& origin, const Instant& now, Crop crop) {
  sensors_.front().see(reading, origin, now, crop);
  unplaced_.forget_old(now, settings_);
  return latched(verdict(), now.steady);
}

Decision SafetyControl::without_cloud(const Instant& now) {
  for (Sensor& sensor : sensors_) sensor.wait(now);
  // What fails to arrive may only worsen a zone.
  return outside_ || is_any_in_doubt() ? latched(verdict(), now.steady) : last_;
}

bool SafetyControl::is_any_in_doubt() const {
  return std::any_of(sensors_.begin(), sensors_.end(),
                     [](const Sensor& sensor) { return std::holds_alternative<Doubt>(sensor.answer()); });
}

Decision SafetyControl::verdict() const {
  if (outside_) return standing_for(*outside_, sensors_.front().counted());
  if (unplaced_.any() && !is_any_in_doubt()) return standing_for(unplaced_, sensors_.front().counted());
  Decision worst = verdict_on(sensors_.front(), settings_.limits);
  for (std::size_t i = 1; i < sensors_.size(); ++i) {
    Decision other = verdict_on(sensors_[i], settings_.limits);
    if (other.zone < worst.zone) worst = std::move(other);
  }
  return worst;
}

const Decision& SafetyControl::latched(Decision verdict, double now) {
  last_ = std::move(verdict);
  last_.zone = latch_.update(last_.zone, now);
  last_.speed = speed_for(last_.zone, settings_.speeds);
  return last_;
}

}  // namespace safety_control_cloud
