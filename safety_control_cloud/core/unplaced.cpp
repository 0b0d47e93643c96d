// SPDX-License-Identifier: BSD-3-Clause
#include "unplaced.hpp"

#include <algorithm>

#include "guard/kept_places.hpp"
#include "memory/patience.hpp"

namespace safety_control_cloud {

void Unplaced::note(const std::string& text) {
  const auto places = kept_places_in(text);
  texts_.push_back({text, places ? std::optional(places->stamp) : std::nullopt});
}

void Unplaced::forget_old(const Instant& now, const Settings& settings) {
  if (!any()) return;
  if (!since_) since_ = now.steady;
  if (Patience{now.steady, settings.near_loss.timeout}.ends(*since_)) return forget();
  const auto is_over = [&](const Text& one) {
    const bool is_kept = settings.memory_distance > 0.0 && settings.memory_time > 0.0;
    return one.placed_at && (!is_kept || are_over(*one.placed_at, now.ros, settings.memory_time));
  };
  texts_.erase(std::remove_if(texts_.begin(), texts_.end(), is_over), texts_.end());
}

std::optional<Doubt> Unplaced::doubt() const {
  if (!any()) return std::nullopt;
  return Doubt{Cause::NearLoss, "what was near or lost before this start cannot be placed"};
}

std::vector<std::string> Unplaced::texts() const {
  std::vector<std::string> all;
  for (const Text& one : texts_) all.push_back(one.text);
  return all;
}

}  // namespace safety_control_cloud
