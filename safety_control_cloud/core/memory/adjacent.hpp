// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

namespace safety_control_cloud {

/// Whether `fulfils(i)` holds for adjacent columns i over 1/share of a picture's width; one alone may be noise.
template <class Fulfils>
bool any_adjacent(std::size_t share, std::size_t width, Fulfils fulfils) {
  const std::size_t least = std::max<std::size_t>(2, width / share);
  std::size_t adjacent = 0;
  for (std::size_t i = 0; i < width; ++i) {
    adjacent = fulfils(i) ? adjacent + 1 : 0;
    if (adjacent >= least) return true;
  }
  return false;
}

}  // namespace safety_control_cloud
