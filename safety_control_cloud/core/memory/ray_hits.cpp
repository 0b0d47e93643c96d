// SPDX-License-Identifier: BSD-3-Clause
#include "ray_hits.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

/// However far beside the grid.
std::ptrdiff_t cell_at(float slope, float least, float cell) {
  constexpr float most = 1e6f;
  return static_cast<std::ptrdiff_t>(std::floor(std::clamp((slope - least) / cell, -most, most)));
}

}  // namespace

std::ptrdiff_t Grid::column(const Point& point) const { return cell_at(point.x / point.z, left, cell); }
std::ptrdiff_t Grid::row(const Point& point) const { return cell_at(point.y / point.z, top, cell); }

void RayHits::take(const Grid& grid, const std::vector<Point>& returns) {
  grid_ = grid;
  pending_ = &returns;
}

void RayHits::fill() const {
  cells_.assign(grid_.width * grid_.height, 0);
  const float part = grid_.cell / static_cast<float>(across);
  const auto width = static_cast<std::ptrdiff_t>(grid_.width), height = static_cast<std::ptrdiff_t>(grid_.height);
  for (const Point& point : *pending_) {
    const std::ptrdiff_t right = cell_at(point.x / point.z, grid_.left, part);
    const std::ptrdiff_t down = cell_at(point.y / point.z, grid_.top, part);
    if (right < 0 || down < 0 || right >= width * across || down >= height * across) continue;
    const auto bit = static_cast<unsigned>(down % across * across + right % across);
    auto& cell = cells_[static_cast<std::size_t>(down / across * width + right / across)];
    cell = static_cast<std::uint16_t>(cell | 1u << bit);
  }
  pending_ = nullptr;
}

float RayHits::down_in(std::size_t row) const { return grid_.top + (static_cast<float>(row) + 0.5f) * grid_.cell; }

bool RayHits::any(float right, float down) const {
  if (pending_) fill();
  const float part = grid_.cell / static_cast<float>(across);
  const std::ptrdiff_t column = cell_at(right, grid_.left, part), row = cell_at(down, grid_.top, part);
  const auto width = static_cast<std::ptrdiff_t>(grid_.width), height = static_cast<std::ptrdiff_t>(grid_.height);
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, row - 1); i <= std::min(row + 1, height * across - 1); ++i) {
    for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, column - 1); j <= std::min(column + 1, width * across - 1);
         ++j) {
      const auto bit = static_cast<unsigned>(i % across * across + j % across);
      if (cells_[static_cast<std::size_t>(i / across * width + j / across)] >> bit & 1u) return true;
    }
  }
  return false;
}

}  // namespace safety_control_cloud
