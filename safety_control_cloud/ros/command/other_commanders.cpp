// SPDX-License-Identifier: BSD-3-Clause
#include "other_commanders.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace safety_control_cloud {
namespace {

constexpr double shortest_silence = 1.0;  ///< [s] after which nobody is believed to have stopped sooner
constexpr double longest_silence = 10.0;  ///< [s] who sends more seldom is a new one each time

double silence_of(double period) { return std::clamp(2.0 * period, shortest_silence, longest_silence); }

std::string listed(const std::set<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

void OtherCommanders::heard(const std::string& name, double now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto [own, is_new] = sent_.try_emplace(name);
  if (!is_new) own->second.period = now - own->second.last;
  own->second.last = now;
}

void OtherCommanders::connected(std::vector<std::string> names) {
  const std::lock_guard<std::mutex> lock(mutex_);
  connected_ = std::move(names);
}

std::optional<Doubt> OtherCommanders::doubt(double now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto sent = sent_.begin(); sent != sent_.end();) {
    sent = now - sent->second.last > silence_of(sent->second.period) ? sent_.erase(sent) : std::next(sent);
  }
  std::set<std::string> commanding, silent(connected_.begin(), connected_.end());
  for (const auto& [name, sent] : sent_) {
    commanding.insert(name);
    silent.erase(name);
  }
  if (!commanding.empty()) return Doubt{Cause::TwoCommanders, listed(commanding) + " commands the robot on " + topic_};
  if (silent.empty()) return std::nullopt;
  return Doubt{Cause::TwoCommanders, listed(silent) + " is about to command the robot on " + topic_};
}

}  // namespace safety_control_cloud
