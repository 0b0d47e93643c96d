// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

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

}  // namespace safety_control_cloud
