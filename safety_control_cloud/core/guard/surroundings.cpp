// SPDX-License-Identifier: BSD-3-Clause
#include "surroundings.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "../look/inside.hpp"

namespace safety_control_cloud {
namespace {

constexpr double near = 0.1;              ///< [m] beyond the margin that are as exact as what is inside it
constexpr double finest = 0.004;          ///< [m] of the innermost cells
constexpr double across_finest = 512.0;   ///< of them at most, from side to side
constexpr double across_coarser = 256.0;  ///< cells

/// The band out to so far [m] to all sides, and a little more, as a corridor that begins behind all of it: what is not
/// in there is left out many points at a time.
Outlook around(const Outlook& outlook, const Band& band, double extent) {
  constexpr double little = 1e-3;  // [m], more than float32 takes away
  Outlook all = outlook;
  all.corridor.x_min = static_cast<float>(-extent - little), all.corridor.x_max = static_cast<float>(extent + little);
  all.corridor.y_min = static_cast<float>(-band.top - little);
  all.corridor.y_max = static_cast<float>(-band.bottom + little);
  all.placement = outlook.placement.value_or(Placement{});
  all.placement->rows[2][3] += static_cast<float>(extent + 1.0);
  return all;
}

}  // namespace

Surroundings::Surroundings(const Outline& outline, Band band)
    : band_(std::move(band)), bottom_(static_cast<float>(band_.bottom)), top_(static_cast<float>(band_.top)) {
  const double inner = outline.reach() + outline.margin() + near, middle = 2.0 * inner + 0.5;
  const double outer = std::max(band_.reach, middle + near);
  cells_.emplace_back(inner, std::max(finest, 2.0 * inner / across_finest));
  cells_.emplace_back(middle, 2.0 * middle / across_coarser);
  cells_.emplace_back(outer, 2.0 * outer / across_coarser);
  for (const Cells& cells : cells_) rings_.push_back({cells.extent(), {}});
}

inline void Surroundings::add(float forward, float left, float up) {
  if (up < bottom_ || up > top_ || is_own(band_.self, forward, left, up)) return;
  for (Cells& cells : cells_) {
    if (!cells.holds(forward, left)) continue;
    cells.add(forward, left);
    return;
  }
}

void Surroundings::look(const View& view, const Outlook& outlook) {
  for (Cells& cells : cells_) cells.clear();
  const Outlook all = around(outlook, band_, cells_.back().extent());
  choose_inside(view, all, [&](const Chosen& inside, const Run& run) {
    for_each_of(inside, run, [&](float x, float y, float z) {
      const Point placed = outlook.placed(x, y, z);
      add(placed.z, -placed.x, -placed.y);
    });
  });
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Obstacles& obstacles = rings_[i].obstacles;
    cells_[i].write(obstacles);
    rings_[i].returns = std::accumulate(obstacles.counts.begin(), obstacles.counts.end(), std::size_t{0});
  }
}

}  // namespace safety_control_cloud
