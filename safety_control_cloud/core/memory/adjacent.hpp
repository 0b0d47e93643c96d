// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace safety_control_cloud {

/// Whether `fulfils(i)` holds for `some` successive i of [0, all).
template <class Fulfils>
bool any_adjacent(std::size_t some, std::size_t all, Fulfils fulfils) {
  std::size_t adjacent = 0;
  for (std::size_t i = 0; i < all; ++i) {
    adjacent = fulfils(i) ? adjacent + 1 : 0;
    if (adjacent >= some) return true;
  }
  return false;
}

}  // namespace safety_control_cloud
