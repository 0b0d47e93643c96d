// SPDX-License-Identifier: BSD-3-Clause
#include "known_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace safety_control_cloud {
namespace {

constexpr std::size_t parts = 320;     ///< of the picture's width
constexpr double most_left = 6.0;      ///< of them: half of what covers the floor at all (memory/floor_strip.cpp)
constexpr double nearest = 0.05;       ///< [m] ahead of a camera: nearer, directions mean nothing
constexpr double beyond_range = 0.05;  ///< [m] at which a camera may still be blind
constexpr double own_size = 0.01;      ///< [m] to each side: one of several places, of which not every one is kept
constexpr double lowest_rows = 0.3;    ///< of the picture: what ends above them hides no near floor

using Parts = std::array<bool, parts>;

std::size_t part_at(double share) {
  return static_cast<std::size_t>(std::clamp(std::floor(share * parts), 0.0, static_cast<double>(parts - 1)));
}

void mark(Parts& marked, double from, double to, bool value) {
  if (to < 0.0 || from > 1.0) return;
  std::fill(marked.begin() + part_at(from), marked.begin() + part_at(to) + 1, value);
}

bool is_hiding(const KnownPlace& known, const FieldOfView& field, double blind_range) {
  const Point& place = known.seen_from_camera;
  if (!(place.z > nearest && place.z < blind_range + beyond_range && known.tells_where_it_is())) return false;
  return place.y / place.z >= field.bottom - lowest_rows * (field.bottom - field.top);
}

}  // namespace

bool hides(const std::vector<KnownPlace>& known, const std::vector<Span>& covered, const FieldOfView& field,
           double blind_range, double left_over) {
  if (covered.empty()) return true;
  if (field.bottom <= field.top || field.right == field.left) return false;
  Parts hidden{};
  for (const Span& span : covered) mark(hidden, span.from, span.to, true);
  for (const KnownPlace& one : known) {
    if (!is_hiding(one, field, blind_range)) continue;
    const Point& place = one.seen_from_camera;
    const double across = (double{place.x} / place.z - field.left) / (field.right - field.left);
    const double half = (own_size + one.off) / place.z / std::abs(field.right - field.left);
    mark(hidden, across - half, across + half, false);
  }
  const auto left = static_cast<double>(std::count(hidden.begin(), hidden.end(), true));
  return left < most_left + left_over * parts;
}

double kept_until(const std::vector<KnownPlace>& known, const FieldOfView& field, double blind_range, double time,
                  double now) {
  double until = now + time;
  for (const KnownPlace& one : known)
    if (is_hiding(one, field, blind_range)) until = std::min(until, one.shown_at + time);
  return until;
}

}  // namespace safety_control_cloud
