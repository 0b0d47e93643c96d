// SPDX-License-Identifier: BSD-3-Clause
#include "surroundings.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "../input/point_reader.hpp"
#include "../look/meaning.hpp"

namespace safety_control_cloud {
namespace {

constexpr double near = 0.1;              ///< [m] beyond the margin that are as exact as what is inside it
constexpr double finest = 0.004;          ///< [m] of the innermost cells
constexpr double across_finest = 512.0;   ///< of them at most, from side to side
constexpr double across_coarser = 256.0;  ///< cells

}  // namespace

Surroundings::Surroundings(const Outline& outline, Band band) : band_(std::move(band)) {
  const double inner = outline.reach() + outline.margin() + near, middle = 2.0 * inner + 0.5;
  const double outer = std::max(band_.reach, middle + near);
  cells_.emplace_back(inner, std::max(finest, 2.0 * inner / across_finest));
  cells_.emplace_back(middle, 2.0 * middle / across_coarser);
  cells_.emplace_back(outer, 2.0 * outer / across_coarser);
  for (const Cells& cells : cells_) rings_.push_back({cells.extent(), {}});
}

void Surroundings::look(const View& view, const Outlook& outlook) {
  for (Cells& cells : cells_) cells.clear();
  const auto bottom = static_cast<float>(band_.bottom), top = static_cast<float>(band_.top);
  for_each_point(view, [&](float x, float y, float z) {
    if (!is_return(x, y, z, outlook.corridor)) return;
    const Point placed = outlook.placed(x, y, z);
    const float forward = placed.z, left = -placed.x, up = -placed.y;
    if (up < bottom || up > top || !cells_.back().holds(forward, left)) return;
    if (is_own(band_.self, forward, left, up)) return;
    for (Cells& cells : cells_) {
      if (!cells.holds(forward, left)) continue;
      cells.add(forward, left);
      return;
    }
  });
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Obstacles& obstacles = rings_[i].obstacles;
    cells_[i].write(obstacles);
    rings_[i].returns = std::accumulate(obstacles.counts.begin(), obstacles.counts.end(), std::size_t{0});
  }
}

}  // namespace safety_control_cloud
