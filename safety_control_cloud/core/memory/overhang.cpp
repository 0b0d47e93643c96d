// SPDX-License-Identifier: BSD-3-Clause
#include "overhang.hpp"

#include <algorithm>
#include <cmath>

#include "thing.hpp"

namespace safety_control_cloud {
namespace {

using Index = NearPixels::Index;

/// What recedes within as many lines, from one down to the other, and goes on there, is overhung. Less than this [m] is
/// noise, or a thing that leans.
constexpr float least_overhang = 0.01f;
constexpr std::size_t overhung_lines = 3, goes_on_lines = 2;

/// By how much a pixel is farther away than the nearest of those right above it, down from `top` [m].
float step_down_to(const NearPixels& found, std::size_t at, std::size_t top) {
  const std::size_t slots = found.slots;
  float step = 0.0f;
  for (std::size_t up = 1; up <= overhung_lines && at >= top + up * slots; ++up)
    step = std::fmax(step, found.ahead[at] - found.ahead[at - up * slots]);
  return step;
}

}  // namespace

float overhang(const NearPixels& found, Index i, Index lowest) {
  const float before = found.ahead[i], least = before + least_overhang;
  float most = 0.0f, some = 0.0f;
  std::size_t goes_on = 0;
  for (std::size_t below = i + found.slots; below <= lowest && most < clear_overhang; below += found.slots) {
    const float ahead = found.ahead[below];
    if (!(ahead > least)) {  // most of them
      if (found.has_pixel(static_cast<Index>(below))) goes_on = 0;
      continue;
    }
    if (goes_on == 0) {
      some = step_down_to(found, below, i);
      if (some <= least_overhang) continue;
    }
    some = std::min(some, ahead - before);
    if (++goes_on >= goes_on_lines) most = std::max(most, some);
  }
  return most;
}

}  // namespace safety_control_cloud
