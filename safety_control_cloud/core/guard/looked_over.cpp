// SPDX-License-Identifier: BSD-3-Clause
#include "looked_over.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace safety_control_cloud {
namespace {

constexpr double over_after = 1.0;     ///< [s] without it: noise takes it from pictures in between
constexpr double beside = 0.04;        ///< [m] by which a front may lie beside where its top meets the border
constexpr double beyond = 0.015;       ///< [m] by which it may lie behind that: noise
constexpr double most_beyond = 0.03;   ///< [m] the same of who is not quite where he is remembered
constexpr std::size_t most_share = 4;  ///< of it, one in so many may be of nothing that is known

bool is_front_of(const KnownPlace& place, const Point2& end, const Point2& eye) {
  const Point2 there = end - eye, known = place.place - eye;
  const double distance = length_of(there);
  if (!(distance > 0.0)) return false;
  const double along = dot(known, there) / distance, across = std::abs(cross(known, there)) / distance;
  return along > 0.0 && along <= distance + beyond + std::min(place.off, most_beyond) && across <= beside + place.off;
}

}  // namespace

/// As it begins: later, its top has rested as long as its front.
void LookedOver::note(const std::vector<Point2>& ends, const Point2& eye, const std::vector<KnownPlace>& known,
                      double now) {
  if (shown_at_ && now - *shown_at_ > over_after) {
    shown_at_.reset();
    is_unknown_ = false;
  }
  if (ends.empty()) return;
  const bool begins = !shown_at_;
  shown_at_ = now;
  if (!begins) return;
  const auto is_unknown = [&](const Point2& end) {
    return std::none_of(known.begin(), known.end(),
                        [&](const KnownPlace& place) { return is_front_of(place, end, eye); });
  };
  const auto unknown = static_cast<std::size_t>(std::count_if(ends.begin(), ends.end(), is_unknown));
  is_unknown_ = unknown * most_share > ends.size();
}

}  // namespace safety_control_cloud
