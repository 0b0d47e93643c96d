// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace safety_control_cloud {

/// The lanes that are set in a mask of eight, each in four bits, the first in the lowest; behind them the first lane.
constexpr std::uint32_t lane_order(std::size_t mask) {
  std::uint32_t order = 0;
  for (std::uint32_t lane = 0, bit = 0; lane < 8; ++lane) {
    if ((mask >> lane & 1U) == 0) continue;
    order |= lane << bit;
    bit += 4;
  }
  return order;
}

/// Of every mask.
constexpr std::array<std::uint32_t, 256> lane_orders = [] {
  std::array<std::uint32_t, 256> orders{};
  for (std::size_t mask = 0; mask < orders.size(); ++mask) orders[mask] = lane_order(mask);
  return orders;
}();

}  // namespace safety_control_cloud
