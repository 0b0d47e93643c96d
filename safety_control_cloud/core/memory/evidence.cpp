// SPDX-License-Identifier: BSD-3-Clause
#include "evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace safety_control_cloud {
namespace {

/// Ranges that agree differ by at most this share.
constexpr float agreement = 0.1f;
/// With as many of the 3 x 3 pixels a spot's surroundings were seen, so that a hole in them means something.
constexpr int dense = 6;
/// Points that lie irregularly return on three rays in four, strays on one in ten: on 1/share at least, if not between
/// rays.
constexpr std::size_t none_share = 5;
constexpr std::size_t enough_rays = 12;
constexpr float as_near = 1.01f;
constexpr double by_rounding = 0.01;  ///< [px]

/// Of the 3 x 3 pixels around a spot.
struct Around {
  std::array<float, 9> behind{};  ///< their distances [m]
  std::size_t count = 0;

  /// How many agree with another one.
  int agreeing() const {
    int some = 0;
    for (std::size_t i = 0; i < count; ++i) {
      bool any = count == 1;
      for (std::size_t j = 0; j < count; ++j) {
        any = any || (i != j && std::abs(behind[i] - behind[j]) <= agreement * std::min(behind[i], behind[j]));
      }
      some += any;
    }
    return some;
  }
};

bool is_in(const Pixels& picture, std::ptrdiff_t row, std::ptrdiff_t column) {
  return row >= 0 && column >= 0 && row < static_cast<std::ptrdiff_t>(picture.height()) &&
         column < static_cast<std::ptrdiff_t>(picture.width());
}

/// Whether a place lies so far within the picture's margins, in which nothing ever returns.
bool is_within(const Pixels& picture, std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t by) {
  const Framing& frame = picture.framing();
  const auto at_least = [by](std::ptrdiff_t at, std::size_t margin) {
    return at - by >= static_cast<std::ptrdiff_t>(margin);
  };
  return at_least(row, frame.top) && at_least(static_cast<std::ptrdiff_t>(picture.height()) - 1 - row, frame.bottom) &&
         at_least(column, frame.left) &&
         at_least(static_cast<std::ptrdiff_t>(picture.width()) - 1 - column, frame.right);
}

/// Whether nothing returns at a place in the picture, nor within so many pixels on two sides of it.
bool is_hole(const Pixels& picture, std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t within) {
  if (!is_within(picture, row, column, within)) return false;
  const auto is_empty = [&](std::ptrdiff_t r, std::ptrdiff_t c) {
    return !returned(picture.near(r, c)) &&
           !picture.never_returns(static_cast<std::size_t>(r), static_cast<std::size_t>(c));
  };
  bool across = true, along = true;
  for (std::ptrdiff_t i = -within; i <= within && (across || along); ++i) {
    across = across && is_empty(row, column + i);
    along = along && is_empty(row + i, column);
  }
  return across || along;
}

/// Nothing returns on a ray, though something does on two sides of it.
bool is_between_rays(float right, float down, const Pixels& picture) {
  if (picture.hits()->any(right, down)) return false;
  const Point along(right, down, 1.0f);
  const std::ptrdiff_t row = picture.hits()->grid().row(along), column = picture.hits()->grid().column(along);
  if (!is_within(picture, row, column, 1)) return false;  // a border's cells are not all within the picture
  const auto filled = [&](std::ptrdiff_t i, std::ptrdiff_t j) { return returned(picture.near(i, j)); };
  return (filled(row, column - 1) && filled(row, column + 1)) || (filled(row - 1, column) && filled(row + 1, column));
}

/// From its middle a hole reaches as far on both sides at least [pixels], along a thing, however thin that is across:
/// the more pixels a picture has, the more of them return nothing by chance, three in a row somewhere on every way.
std::ptrdiff_t reach_of_hole(const Pixels& picture) {
  constexpr std::ptrdiff_t coarse = 160;  // pixels across, of which three are 9 mm at 0.4 m
  return std::max<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>(picture.width()) / coarse);
}

/// Whether there is a hole where the thing would have moved to.
bool hole_on_the_way(const Spot& spot, const Pixels& picture, std::ptrdiff_t within) {
  if (spot.company < dense || !spot.is_shown()) return false;
  const double down = spot.row - picture.framing().middle_row;
  const double right = spot.column - picture.framing().middle_column;
  const auto steps = static_cast<int>(std::ceil(growth * std::max(std::abs(down), std::abs(right))));
  for (int i = 0; i <= steps; ++i) {
    const double part = growth * i / std::max(1, steps);
    const auto row = std::lround(spot.row + part * down), column = std::lround(spot.column + part * right);
    if (!is_in(picture, row, column)) return false;  // outward there is nothing more
    if (is_hole(picture, row, column, within)) return true;
  }
  return false;
}

/// Whether there is a way nearer after which nothing would return on most of the rays that `ask_rays` asks about for a
/// spot at its new distance z [m]. Only the nearest spots are asked, since where the others have moved to by now is not
/// known.
template <class AskRays>
bool any_way_between_rays(std::vector<Spot> spots, const Pixels& picture, AskRays ask_rays) {
  if (!picture.hits() || spots.empty()) return false;
  const auto is_nearer = [](const Spot& a, const Spot& b) { return a.point.z < b.point.z; };
  std::sort(spots.begin(), spots.end(), is_nearer);
  const float nearest = spots.front().point.z, farthest_way = nearest * static_cast<float>(growth / (1.0 + growth));
  while (spots.size() > enough_rays && spots.back().point.z > as_near * nearest) spots.pop_back();
  constexpr int steps = 40;  // of a quarter of the distance of rays at most, 30 degrees aside of 160
  for (int i = 0; i <= steps; ++i) {
    const float way = farthest_way * static_cast<float>(i) / steps;
    std::size_t asked = 0, between = 0;
    const auto ask = [&](float right, float down) {
      ++asked;
      between += is_between_rays(right, down, picture);
    };
    for (const Spot& spot : spots) ask_rays(spot, spot.point.z - way, ask);
    if (between * none_share > asked * (none_share - 1)) return true;
  }
  return false;
}

}  // namespace

bool leaves_a_hole(const Spot& spot, const Pixels& picture) {
  return hole_on_the_way(spot, picture, 2 * reach_of_hole(picture));
}

bool may_lie_between_rays(std::vector<Spot> spots, const Pixels& picture) {
  return any_way_between_rays(std::move(spots), picture, [](const Spot& spot, float z, const auto& ask) {
    ask(spot.point.x / z, spot.point.y / z);
  });
}

bool may_stand_between_rays(std::vector<Spot> spots, const std::vector<std::size_t>& rows, const Pixels& picture) {
  return any_way_between_rays(std::move(spots), picture, [&](const Spot& spot, float z, const auto& ask) {
    for (const std::size_t row : rows) ask(spot.point.x / z, picture.hits()->down_in(row));
  });
}

/// A row that just does not, by the half pixels in which cameras tell their middle, does: a cloud tells that by its
/// returns, but for rounding.
bool leaves_at_the_top(const Spot& spot, const Pixels& picture) {
  const double middle = picture.framing().middle_row;
  return (1.0 + growth) * (middle - spot.row) > middle - by_rounding;
}

/// There the last rows may never return.
bool leaves_at_the_bottom(const Spot& spot, const std::optional<float>& nearer, const Pixels& picture) {
  if (!nearer || !spot.is_shown() || spot.only_hides) return false;
  const auto last = static_cast<double>(picture.height() - 1 - picture.framing().bottom);
  const double middle = picture.framing().middle_row, below = spot.row - middle;
  const double by_now = double{spot.point.z - std::max(*nearer, spot.came_nearer)};
  return below > 0.0 && below * double{spot.point.z} > (last - middle) * by_now;
}

Evidence evidence_of(const Spot& spot, const Pixels& picture) {
  if (!spot.is_shown()) return Evidence::Nothing;
  const float then = spot.point.z, noise = noise_at(then);
  Around around;
  int there = 0, before = 0;
  for (const float z : picture.around(spot.row, spot.column)) {
    if (std::isnan(z)) continue;
    if (z > then + noise) around.behind[around.count++] = z;
    (z < then - noise ? before : there) += z <= then + noise;
  }
  const int enough = (spot.company + 1) / 2;
  if (there + before >= enough) return there > 0 ? Evidence::There : Evidence::Hidden;
  const int behind = around.agreeing();
  if (behind == 0 || 2 * behind < spot.company || 4 * (behind + there) < 3 * spot.company) return Evidence::Nothing;
  if (hole_on_the_way(spot, picture, reach_of_hole(picture))) return Evidence::Nothing;
  return Evidence::Past;
}

}  // namespace safety_control_cloud
