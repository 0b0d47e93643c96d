// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "../input/runs.hpp"
#include "outlook.hpp"

namespace safety_control_cloud {

/// An upright box in the corridor's axes [m]; its limits belong to it.
struct Region {
  float x_min, x_max, y_min, y_max, z_min, z_max;
};

/// Where some returns lie, in the corridor's axes [m], in the cloud's order.
struct Places {
  static constexpr std::size_t longest_vector = 64;  ///< lanes; a vector is stored whole, wherever its last point ends

  std::array<float, Runs::longest + longest_vector> x, y, z;
  std::size_t size = 0;
};

/// Where the returns of a run lie that are in a region, whichever corridor there is. Into what was there.
void gather(const Run& run, const Outlook& outlook, const Region& region, Places& places);

using TakePlaces = std::function<void(Places&)>;

/// What else is done in the pass over a view's points: where the returns lie that are in a region, by an outlook of its
/// own, is gathered and taken, run by run in their order.
struct Alongside {
  Outlook outlook;
  Region region;
  TakePlaces take;
};

/// A square around the corridor's axes, seen from above, in cells that are numbered from `first` on, row by row.
struct CellGrid {
  float extent;     ///< [m] to each side
  float per_metre;  ///< cells
  std::int32_t side, first;
};

constexpr std::int32_t in_no_cell = 0;
using CellNumbers = std::array<std::int32_t, Runs::longest + Places::longest_vector>;

/// The cell of each place: of the smallest grid that holds it, or none. The grids stand from the smallest on, and have
/// fewer cells than a float can count.
void find_cells(const Places& places, const std::vector<CellGrid>& grids, CellNumbers& cells);

}  // namespace safety_control_cloud
