// SPDX-License-Identifier: BSD-3-Clause
#include "cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace safety_control_cloud {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::int32_t outside = 0;  ///< the cell of what no square holds

/// Returns that follow each other are often of one cell, and what is stored there must have arrived before it is
/// loaded again: so many parts of a run take turns.
constexpr std::size_t parts = 4;

}  // namespace

Cells::Cells(const std::vector<Square>& squares) {
  Cell first = outside + 1;
  for (const auto& [extent, cell] : squares) {
    const auto side = static_cast<std::int32_t>(std::ceil(2.0 * extent / cell)) + 1;
    grids_.push_back({static_cast<float>(extent), static_cast<float>(1.0 / cell), side, first});
    first += side * side;
  }
  const auto cells = static_cast<std::size_t>(first);
  least_.resize(cells, {infinity, infinity, infinity, infinity});
  counts_.resize(cells, 0);
  used_.resize(cells + 1);  // behind the last too something is written, and does not count
}

void Cells::clear() {
  for (std::size_t i = 0; i < used_size_; ++i) {
    const auto cell = static_cast<std::size_t>(used_[i]);
    least_[cell].fill(infinity);
    counts_[cell] = 0;
  }
  used_size_ = 0;
}

/// Without a branch, many at a time, on machines too that multiply no vectors of integers: a float holds them. The
/// largest square first, so that a smaller one has the last word.
void Cells::find_cells(const Places& places) {
  for (std::size_t i = 0; i < places.size; ++i) {
    x_[i] = places.z[i];
    y_[i] = -places.x[i];
    cell_[i] = outside;
  }
  const float *const xs = x_.data(), *const ys = y_.data();
  for (auto grid = grids_.rbegin(); grid != grids_.rend(); ++grid) {
    const float extent = grid->extent, per_metre = grid->per_metre;
    const auto side = static_cast<float>(grid->side);
    const Cell first = grid->first;
    const auto holds = [=](float x, float y) { return (x > -extent) & (x < extent) & (y > -extent) & (y < extent); };
    int any = 0;
    for (std::size_t i = 0; i < places.size; ++i) any |= holds(xs[i], ys[i]);
    if (any == 0) return;
    for (std::size_t i = 0; i < places.size; ++i) {
      const bool is_held = holds(xs[i], ys[i]);
      const auto column = static_cast<float>(static_cast<Cell>((is_held ? xs[i] + extent : 0.0f) * per_metre));
      const auto row = static_cast<float>(static_cast<Cell>((is_held ? ys[i] + extent : 0.0f) * per_metre));
      const Cell cell = first + static_cast<Cell>(row * side + column);
      cell_[i] = is_held ? cell : cell_[i];
    }
  }
}

inline void Cells::include(std::size_t i) {
  const auto cell = static_cast<std::size_t>(cell_[i]);
  const Least one{x_[i], -x_[i], y_[i], -y_[i]};
  Least& least = least_[cell];
  for (std::size_t side = 0; side < one.size(); ++side) least[side] = one[side] < least[side] ? one[side] : least[side];
  used_[used_size_] = cell_[i];
  used_size_ += counts_[cell]++ == 0 ? 1 : 0;
}

void Cells::add(const Places& places) {
  find_cells(places);
  const std::size_t part = places.size / parts;
  for (std::size_t i = 0; i < part; ++i)
    for (std::size_t begin = 0; begin < parts * part; begin += part) include(begin + i);
  for (std::size_t i = parts * part; i < places.size; ++i) include(i);
}

void Cells::write(std::size_t square, Obstacles& obstacles) const {
  obstacles.points.clear();
  obstacles.counts.clear();
  obstacles.widening = 0.0;
  const Grid& grid = grids_[square];
  const Cell end = grid.first + grid.side * grid.side;
  for (std::size_t i = 0; i < used_size_; ++i) {
    if (used_[i] < grid.first || used_[i] >= end) continue;
    const auto cell = static_cast<std::size_t>(used_[i]);
    const Least& of = least_[cell];
    const Point2 least{of[0], of[2]}, most{-of[1], -of[3]};
    obstacles.points.push_back(0.5 * (least + most));
    obstacles.counts.push_back(counts_[cell]);
    obstacles.widening = std::max(obstacles.widening, 0.5 * length_of(most - least));
  }
}

}  // namespace safety_control_cloud
