// SPDX-License-Identifier: BSD-3-Clause
#include "column_below.hpp"

#include <algorithm>

namespace safety_control_cloud {
namespace {

/// Strays return one by one, at any range; as many rows that are read in which one goes on show something.
constexpr std::size_t no_strays = 3;
constexpr float agreement = 0.15f;  ///< share by which the floor's range changes from one of them to the next
/// Of the rows below an edge, so many may show a stray return where something too near hides the floor: 1/share.
constexpr std::size_t stray_share = 6;

}  // namespace

ColumnBelow::ColumnBelow(const Foot& foot, std::size_t column, const GroundPicture& shown)
    : foot_(foot),
      shown_(shown),
      ground_(shown.ground),
      column_(column),
      most_blank_(std::max<std::size_t>(1, shown.picture.height() / shown.ground.row_step() / blank_share)) {}

Stand ColumnBelow::stand() const {
  std::size_t lowest = ground_.row_at(foot_.row);
  const auto surface = surface_below(lowest);
  auto other = surface ? std::optional<Seen>(seen_in(*surface)) : std::nullopt;
  if (!other || is_near(*other) || !is_farther(*other)) {
    lowest = lowest_from(lowest);
    if (other && *surface >= lowest) other.reset();
  }
  const Below below = other ? Below() : below_row(lowest);
  // Where no surface goes on, something else than ground may show in much of what is below the thing.
  if (2 * below.others > below.blank) other = below.other;
  // What reaches the floor below its foot is another thing.
  if (other) return is_near(*other) || is_farther(*other) ? Stand::Hangs : Stand::Unseen;
  if (!below.gap && lowest < ground_.rows()) return Stand::Stands;
  return below.gap && !(below.ground && is_farther(*below.ground)) ? Stand::Unseen : Stand::Hangs;
}

bool ColumnBelow::is_hidden() const {
  const std::size_t rows = std::min(ground_.row_at(foot_.row), ground_.rows());
  const auto goes_on = [this] {
    return may_be_of(foot_, shown_.ahead(shown_.placed_at(foot_.row, ground_.picture_column(column_))));
  };
  return rows > 0 && !goes_on() && !surface_below(rows) &&
         below_row(rows).blank * stray_share >= rows * (stray_share - 1);
}

/// How far ahead of the camera what returns there is [m]; NaN: nothing does. Of some rows, not all columns have been
/// read.
float ColumnBelow::ahead_in(std::size_t i) const {
  if (ground_.is_whole(i)) return ground_.ahead(i)[column_];
  return shown_.ahead(shown_.placed_at(ground_.picture_row(i), ground_.picture_column(column_)));
}

ColumnBelow::Seen ColumnBelow::seen_in(std::size_t i) const {
  if (ground_.is_whole(i)) return {ground_.row(i)[column_], ground_.ahead(i)[column_]};
  const Point place = shown_.placed_at(ground_.picture_row(i), ground_.picture_column(column_));
  const float ahead = shown_.ahead(place);
  if (!returned(place)) return {NearGround::nothing, ahead};
  return {shown_.outlook.corridor.holds(place) && ahead < ground_.distance() ? NearGround::near : NearGround::elsewhere,
          ahead};
}

ColumnBelow::Below ColumnBelow::below_row(std::size_t lowest) const {
  Below below;
  std::size_t missing = 0;
  for (std::size_t i = 0; i < std::min(lowest, ground_.rows()); ++i) {
    const Seen seen = seen_in(i);
    const bool is_ground = seen.code >= 0;
    const bool is_other = seen.code == NearGround::elsewhere || (is_near(seen) && !is_of_thing(seen));
    below.blank += seen.code == NearGround::nothing;
    below.others += is_other;
    if (is_other) below.other = seen;
    if (is_ground) below.ground = seen;
    missing = is_ground || is_near(seen) ? 0 : missing + 1;
    below.gap = below.gap || missing > most_blank_;
  }
  return below;
}

/// The lowest row in which the thing is seen, from that of its foot down. Its border, if it is about to be too near,
/// returns here and there alone.
std::size_t ColumnBelow::lowest_from(std::size_t lowest) const {
  std::size_t others = 0;
  for (std::size_t i = lowest; i-- > 0 && lowest - i <= most_blank_ + 1 && others < no_strays;) {
    const float ahead = ahead_in(i);
    const bool same = may_be_of(foot_, ahead), is_other = !same & !std::isnan(ahead);
    others = (others + 1) * is_other;
    lowest = same ? i : lowest;
  }
  return lowest;
}

/// The first row below `lowest` in which it shows a surface, and no ground: rows that follow one another agree,
/// unlike strays.
std::optional<std::size_t> ColumnBelow::surface_below(std::size_t lowest) const {
  std::size_t adjacent = 0;
  for (std::size_t i = 0; i < std::min(lowest, ground_.rows()); ++i) {
    const Code code = ground_.row(i)[column_];
    adjacent = code == NearGround::elsewhere || code == NearGround::near ? adjacent + 1 : 0;
    if (adjacent < no_strays) continue;
    const float ahead = ahead_in(i), before = ahead_in(i - 1);
    if (std::abs(ahead - before) <= agreement * std::min(ahead, before)) return i;
  }
  return std::nullopt;
}

}  // namespace safety_control_cloud
