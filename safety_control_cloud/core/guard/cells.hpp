// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../look/places.hpp"
#include "../path/obstacles.hpp"

namespace safety_control_cloud {

/// reduced() of returns that come run by run, into cells of several sizes: squares around base_frame's origin, of which
/// each holds what no smaller one does. What they hold they have held since they were made, so that filling them
/// allocates nothing.
class Cells {
 public:
  struct Square {
    double extent, cell;  ///< [m] from the origin to each side; the width of a cell
  };

  /// From the smallest.
  explicit Cells(const std::vector<Square>& squares);

  /// Returns in base_frame, seen from above. What no square holds is left out.
  void add(const Places& places);
  void clear();

  /// One point for each cell of a square: the middle of its returns, with how far the farthest of all lies from its
  /// own. Into what another look has left behind.
  void write(std::size_t square, Obstacles& obstacles) const;

 private:
  using Cell = std::int32_t;
  using Least = float __attribute__((vector_size(16)));  ///< of the returns of a cell: x, y, -x and -y [m]

  void include(Cell cell, float x, float y);

  std::vector<CellGrid> grids_;
  std::vector<Least> least_;           ///< of each cell
  std::vector<std::uint32_t> counts_;  ///< of its returns
  std::vector<Cell> used_;             ///< those that have any, as they came
  std::size_t used_size_ = 0;
  CellNumbers cell_;  ///< of a run's places
};

}  // namespace safety_control_cloud
