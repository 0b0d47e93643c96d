// SPDX-License-Identifier: BSD-3-Clause
#include "floor_strip.hpp"

#include <algorithm>

namespace safety_control_cloud {
namespace {

/// A post of 2 cm at 0.4 m, where an Xtion goes blind, takes 1/24 of its 60 degrees.
constexpr std::size_t post_share_of_width = 24;

/// The floor moves by 2 % in a row when the robot pitches by half a degree; a foot stands out by more than this.
bool is_floor(std::uint16_t code, std::uint16_t farthest) {
  const int distance = code - PixelMemory::ground_zero, floor = farthest - PixelMemory::ground_zero;
  return distance * 10 >= floor * 9;
}

}  // namespace

void FloorStrip::survey(const PixelMemory& memory) {
  if (farthest_.size() != memory.height) farthest_.assign(memory.height, 0);
  columns_.assign(memory.width, Column{});
  for (std::size_t row = memory.height; row-- > 0;) {
    if (!learn_row(memory, row)) return;
    count_row(memory, row);
  }
}

/// False where the strip ends.
bool FloorStrip::learn_row(const PixelMemory& memory, std::size_t row) {
  std::uint16_t farthest = farthest_[row];
  for (std::size_t i = 0; i < memory.width; ++i) {
    const std::uint16_t code = PixelMemory::code_of(memory.row(row)[i]);
    if (PixelMemory::is_ground(code)) farthest = std::max(farthest, code);
  }
  farthest_[row] = farthest;
  return farthest > 0;
}

void FloorStrip::count_row(const PixelMemory& memory, std::size_t row) {
  for (std::size_t i = 0; i < memory.width; ++i) {
    const std::uint16_t pixel = memory.row(row)[i], code = PixelMemory::code_of(pixel);
    if (code == PixelMemory::nothing) continue;
    const bool seen_past =
        code == PixelMemory::elsewhere || (PixelMemory::is_ground(code) && is_floor(code, farthest_[row]));
    if (PixelMemory::is_now(pixel) && seen_past) {
      ++columns_[i].shown;
    } else {
      ++columns_[i].hidden;
      if (!PixelMemory::is_now(pixel)) ++columns_[i].blank;
    }
  }
}

bool FloorStrip::is_covered() const {
  const std::size_t post = std::max<std::size_t>(2, columns_.size() / post_share_of_width);
  std::size_t adjacent = 0;
  for (const Column& column : columns_) {
    const bool covered = column.blank >= 2 && column.blank >= 3 * (column.shown + column.hidden - column.blank);
    adjacent = covered ? adjacent + 1 : 0;
    if (adjacent >= post) return true;
  }
  return false;
}

}  // namespace safety_control_cloud
