// SPDX-License-Identifier: BSD-3-Clause
#include "usual_cells.hpp"

#include <cmath>
#include <utility>

namespace safety_control_cloud {

void UsualCells::note(const std::vector<std::array<float, 3>>& cells, std::size_t width, bool anything_near) {
  cells_.resize(cells.size());
  width_ = width;
  const bool is_some = ++pictures_ % some == 0;
  learns_ = false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Cell& cell = cells_[i];
    cell.returned = static_cast<std::uint8_t>(cell.returned + !std::isnan(cells[i][2]));
    cell.free = static_cast<std::uint8_t>(cell.free + (!anything_near && cell.free < enough));
    learns_ = learns_ || cell.free < enough;
    if (!is_some) continue;
    cell.usual = cell.usual || cell.returned >= many_of_some;
    cell.returned = 0;
  }
}

void UsualCells::grow(const Growth& growth) {
  std::vector<Cell> grown(growth.width * growth.height);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const std::size_t row = i / width_ + growth.above, column = i % width_ + growth.left;
    if (row < growth.height && column < growth.width) grown[row * growth.width + column] = cells_[i];
  }
  cells_ = std::move(grown);
  width_ = growth.width;
  learns_ = true;
}

}  // namespace safety_control_cloud
