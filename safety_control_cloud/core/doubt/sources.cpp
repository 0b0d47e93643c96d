// SPDX-License-Identifier: BSD-3-Clause
#include "sources.hpp"

#include <algorithm>
#include <iterator>

namespace safety_control_cloud {
namespace {

constexpr double longest_period = 10.0;  ///< [s] a source that sends more seldom is a new one each time

}  // namespace

std::optional<Doubt> SourceWatch::note(const std::string& source, double now, double timeout) {
  for (auto sent = sent_.begin(); sent != sent_.end();) {
    sent = now - sent->second.last > std::max(longest_period, timeout) ? sent_.erase(sent) : std::next(sent);
  }
  const auto [own, is_new] = sent_.try_emplace(source);
  if (!is_new) own->second.period = now - own->second.last;
  own->second.last = now;
  const bool others = std::any_of(sent_.begin(), sent_.end(), [&](const auto& other) {
    const auto& [name, sent] = other;
    return name != source && now - sent.last <= std::max(timeout, 2.0 * sent.period);
  });
  if (!others) return std::nullopt;
  return Doubt{Cause::TwoSources, "clouds of two publishers arrive in turn"};
}

}  // namespace safety_control_cloud
