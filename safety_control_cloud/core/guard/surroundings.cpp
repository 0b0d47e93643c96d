// SPDX-License-Identifier: BSD-3-Clause
#include "surroundings.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace safety_control_cloud {
namespace {

constexpr double near = 0.1;              ///< [m] beyond the margin that are as exact as what is inside it
constexpr double finest = 0.004;          ///< [m] of the innermost cells
constexpr double across_finest = 512.0;   ///< of them at most, from side to side
constexpr double across_coarser = 256.0;  ///< cells

std::vector<Cells::Square> squares_of(const Outline& outline, double reach) {
  const double inner = outline.reach() + outline.margin() + near, middle = 2.0 * inner + 0.5;
  const double outer = std::max(reach, middle + near);
  return {{inner, std::max(finest, 2.0 * inner / across_finest)},
          {middle, 2.0 * middle / across_coarser},
          {outer, 2.0 * outer / across_coarser}};
}

/// The band out to so far [m] to all sides.
Region region_of(const Band& band, double extent) {
  const auto out = static_cast<float>(extent);
  return {-out, out, -static_cast<float>(band.top), -static_cast<float>(band.bottom), -out, out};
}

}  // namespace

Surroundings::Surroundings(const Outline& outline, Band band)
    : band_(std::move(band)), cells_(squares_of(outline, band_.reach)) {
  for (const Cells::Square& square : squares_of(outline, band_.reach)) rings_.push_back({square.extent, {}});
  region_ = region_of(band_, rings_.back().extent);
}

Alongside Surroundings::begin(const Outlook& outlook) {
  cells_.clear();
  return {outlook, region_, [this](Places& places) { take(places); }};
}

void Surroundings::take(Places& places) {
  if (!band_.self.empty()) leave_out_own(places);
  cells_.add(places);
}

void Surroundings::finish() {
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    Obstacles& obstacles = rings_[i].obstacles;
    cells_.write(i, obstacles);
    rings_[i].returns = std::accumulate(obstacles.counts.begin(), obstacles.counts.end(), std::size_t{0});
  }
}

void Surroundings::leave_out_own(Places& places) const {
  std::size_t size = 0;
  for (std::size_t i = 0; i < places.size; ++i) {
    const float x = places.x[i], y = places.y[i], z = places.z[i];
    places.x[size] = x, places.y[size] = y, places.z[size] = z;
    size += is_own(band_.self, z, -x, -y) ? 0 : 1;
  }
  places.size = size;
}

}  // namespace safety_control_cloud
