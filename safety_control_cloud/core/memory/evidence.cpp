// SPDX-License-Identifier: BSD-3-Clause
#include "evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace safety_control_cloud {
namespace {

/// By so much a thing grows in the picture when a robot that brakes comes nearer than it can see.
constexpr double growth = 0.25;
/// Ranges that agree differ by at most this share.
constexpr float agreement = 0.1f;
/// With as many of the 3 x 3 pixels a spot's surroundings were seen, so that a hole in them means something.
constexpr int dense = 6;

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

bool is_hole(const Pixels& picture, std::ptrdiff_t row, std::ptrdiff_t column) {
  if (row < 1 || column < 1) return false;
  if (row + 1 >= static_cast<std::ptrdiff_t>(picture.height())) return false;
  if (column + 1 >= static_cast<std::ptrdiff_t>(picture.width())) return false;
  const auto blank = [&](std::ptrdiff_t i, std::ptrdiff_t j) { return !returned(picture.near(i, j)); };
  if (!blank(row, column)) return false;
  return (blank(row, column - 1) && blank(row, column + 1)) || (blank(row - 1, column) && blank(row + 1, column));
}

/// Whether there is a hole where the thing would have moved to.
bool hole_on_the_way(const Spot& spot, const Pixels& picture) {
  const double down = spot.row - 0.5 * static_cast<double>(picture.height());
  const double right = spot.column - 0.5 * static_cast<double>(picture.width());
  const auto steps = static_cast<int>(std::ceil(growth * std::max(std::abs(down), std::abs(right))));
  for (int i = 0; i <= steps; ++i) {
    const double part = growth * i / std::max(1, steps);
    if (is_hole(picture, std::lround(spot.row + part * down), std::lround(spot.column + part * right))) return true;
  }
  return false;
}

}  // namespace

bool leaves_a_hole(const Spot& spot, const Pixels& picture) {
  return spot.company >= dense && hole_on_the_way(spot, picture);
}

bool leaves_at_the_top(const Spot& spot, const Pixels& picture) {
  const double middle = 0.5 * static_cast<double>(picture.height());
  return (1.0 + growth) * (middle - spot.row) > middle;
}

Evidence evidence_of(const Spot& spot, const Pixels& picture) {
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
  if (around.count == 0 || 4 * around.agreeing() < 3 * spot.company) return Evidence::Nothing;
  if (leaves_a_hole(spot, picture)) return Evidence::Nothing;
  return Evidence::Past;
}

}  // namespace safety_control_cloud
