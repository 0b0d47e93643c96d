// SPDX-License-Identifier: BSD-3-Clause
#include "cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace safety_control_cloud {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nothing __attribute__((vector_size(16))) = {infinity, infinity, infinity, infinity};

/// Returns that follow each other are often of one cell, and what is stored there must have arrived before it is
/// loaded again: so many parts of a run take turns.
constexpr std::size_t parts = 4;

}  // namespace

Cells::Cells(const std::vector<Square>& squares) {
  Cell first = in_no_cell + 1;
  for (const auto& [extent, cell] : squares) {
    const auto side = static_cast<std::int32_t>(std::ceil(2.0 * extent / cell)) + 1;
    grids_.push_back({static_cast<float>(extent), static_cast<float>(1.0 / cell), side, first});
    first += side * side;
  }
  const auto cells = static_cast<std::size_t>(first);
  least_.resize(cells, nothing);
  counts_.resize(cells, 0);
  used_.resize(cells + 1);  // behind the last too something is written, and does not count
}

void Cells::clear() {
  for (std::size_t i = 0; i < used_size_; ++i) {
    const auto cell = static_cast<std::size_t>(used_[i]);
    least_[cell] = nothing;
    counts_[cell] = 0;
  }
  used_size_ = 0;
}

inline void Cells::include(Cell number, float x, float y) {
  const auto cell = static_cast<std::size_t>(number);
  const Least one = {x, y, -x, -y}, least = least_[cell];
  least_[cell] = one < least ? one : least;
  used_[used_size_] = number;
  used_size_ += counts_[cell]++ == 0 ? 1 : 0;
}

void Cells::add(const Places& places) {
  find_cells(places, grids_, cell_);
  const auto take = [&](std::size_t i) { include(cell_[i], places.z[i], -places.x[i]); };
  const std::size_t part = places.size / parts;
  for (std::size_t i = 0; i < part; ++i)
    for (std::size_t begin = 0; begin < parts * part; begin += part) take(begin + i);
  for (std::size_t i = parts * part; i < places.size; ++i) take(i);
}

void Cells::write(std::size_t square, Obstacles& obstacles) const {
  obstacles.points.clear();
  obstacles.counts.clear();
  obstacles.widening = 0.0;
  const CellGrid& grid = grids_[square];
  const Cell end = grid.first + grid.side * grid.side;
  for (std::size_t i = 0; i < used_size_; ++i) {
    if (used_[i] < grid.first || used_[i] >= end) continue;
    const auto cell = static_cast<std::size_t>(used_[i]);
    const Least of = least_[cell];
    const Point2 least{of[0], of[1]}, most{-of[2], -of[3]};
    obstacles.points.push_back(0.5 * (least + most));
    obstacles.counts.push_back(counts_[cell]);
    obstacles.widening = std::max(obstacles.widening, 0.5 * length_of(most - least));
  }
}

}  // namespace safety_control_cloud
