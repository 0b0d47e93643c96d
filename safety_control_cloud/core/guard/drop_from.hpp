// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <iterator>

namespace safety_control_cloud {

/// Of a map, whatever goes; how many that were. C++20 has it as std::erase_if.
template <class Map, class Goes>
std::size_t drop_from(Map& map, Goes goes) {
  const std::size_t before = map.size();
  for (auto it = map.begin(); it != map.end();) it = goes(*it) ? map.erase(it) : std::next(it);
  return before - map.size();
}

}  // namespace safety_control_cloud
