// SPDX-License-Identifier: BSD-3-Clause
#include "floor_strip.hpp"

#include <algorithm>
#include <utility>

namespace safety_control_cloud {
namespace {

/// A post of 2 cm at 0.4 m, where an Xtion goes blind, takes 1/24 of its 60 degrees.
constexpr std::size_t post_share_of_width = 24;

/// The floor moves by 2 % in a row when the robot pitches by half a degree; a foot stands out by more than this.
bool is_floor(std::uint16_t code, std::uint16_t lowest) {
  const int below = code - PixelMemory::ground_zero, floor = lowest - PixelMemory::ground_zero;
  return below * 20 >= floor * 19;
}

/// From the first pixel of a row that returned at some time to behind the last: cameras leave a border of their
/// pictures empty, but a gap between floor and floor hides something, even if it was there from the start.
std::pair<std::size_t, std::size_t> span_of_returns(const std::uint16_t* pixels, std::size_t width) {
  std::size_t first = 0, last = width;
  while (first < last && PixelMemory::code_of(pixels[first]) == PixelMemory::nothing) ++first;
  while (last > first && PixelMemory::code_of(pixels[last - 1]) == PixelMemory::nothing) --last;
  return {first, last};
}

}  // namespace

void FloorStrip::survey(const PixelMemory& memory) {
  if (lowest_.size() != memory.height) lowest_.assign(memory.height, 0);
  columns_.assign(memory.width, Column{});
  for (std::size_t row = memory.height; row-- > 0;) {
    if (!learn_row(memory, row)) return;
    count_row(memory, row);
  }
}

/// False where the strip ends.
bool FloorStrip::learn_row(const PixelMemory& memory, std::size_t row) {
  const std::uint16_t* pixels = memory.row(row);
  std::uint16_t lowest = lowest_[row];
  for (std::size_t i = 1; i < memory.width; ++i) {
    const std::uint16_t left = PixelMemory::code_of(pixels[i - 1]), right = PixelMemory::code_of(pixels[i]);
    const bool both = PixelMemory::is_ground(left) && PixelMemory::is_ground(right);  // one alone may be noise
    if (both) lowest = std::max(lowest, std::min(left, right));
  }
  lowest_[row] = lowest;
  floor_ = std::max(floor_, lowest);
  return lowest > 0 && is_floor(lowest, floor_);
}

void FloorStrip::count_row(const PixelMemory& memory, std::size_t row) {
  const std::uint16_t* pixels = memory.row(row);
  const auto [first, last] = span_of_returns(pixels, memory.width);
  for (std::size_t i = first; i < last; ++i) {
    const std::uint16_t pixel = pixels[i], code = PixelMemory::code_of(pixel);
    Column& column = columns_[i];
    if (code == PixelMemory::nothing) {
      ++column.blank;
      continue;
    }
    const bool seen_past =
        code == PixelMemory::elsewhere || (PixelMemory::is_ground(code) && is_floor(code, lowest_[row]));
    const bool now = PixelMemory::is_now(pixel);
    ++(now && seen_past ? column.shown : column.hidden);
    if (!now) ++column.blank;
    if (now && !seen_past) ++column.foot;
  }
}

bool FloorStrip::is_covered() const {
  const std::size_t post = std::max<std::size_t>(2, columns_.size() / post_share_of_width);
  std::size_t adjacent = 0;
  for (const Column& column : columns_) {
    const bool covered = column.blank >= 2 && column.blank >= 3 * (column.shown + column.foot);
    adjacent = covered ? adjacent + 1 : 0;
    if (adjacent >= post) return true;
  }
  return false;
}

}  // namespace safety_control_cloud
