// SPDX-License-Identifier: BSD-3-Clause
#include "floor_strip.hpp"

#include <algorithm>
#include <utility>

#include "adjacent.hpp"

namespace safety_control_cloud {
namespace {

/// A post of 2 cm at 0.4 m, where an Xtion goes blind, takes 1/24 of its 60 degrees.
constexpr std::size_t post_share_of_width = 24;

/// Stereo cameras have the widest borders, of 4 to 6 % at 0.7 m.
constexpr std::size_t border_share_of_width = 8;

/// A row's floor rises by this in a cloud in which none is seen as low [mm]: after a bump it is back in a second.
constexpr std::uint16_t forgotten = 1;

/// The least code that is still floor in a row; those from it on are the floor, or elsewhere. The floor moves by 2 %
/// when the robot pitches by half a degree; a foot stands out by more than this.
std::uint16_t least_floor(std::uint16_t lowest) {
  const int floor = lowest - PixelMemory::ground_zero;
  return static_cast<std::uint16_t>(PixelMemory::ground_zero + (floor * 19 + 19) / 20);
}

/// From the first pixel of a row that returned at some time to behind the last: cameras leave a border of their
/// pictures empty, but a gap between floor and floor hides something, even if it was there from the start. So does a
/// border wider than any camera's.
std::pair<std::size_t, std::size_t> span_of_returns(const std::uint16_t* pixels, std::size_t width) {
  std::size_t first = 0, last = width;
  while (first < last && PixelMemory::code_of(pixels[first]) == PixelMemory::nothing) ++first;
  while (last > first && PixelMemory::code_of(pixels[last - 1]) == PixelMemory::nothing) --last;
  const std::size_t border = width / border_share_of_width;
  return {first > border ? 0 : first, width - last > border ? width : last};
}

}  // namespace

void FloorStrip::survey(const PixelMemory& memory) {
  if (lowest_.size() != memory.height) lowest_.assign(memory.height, 0);
  for (auto* counts : {&shown_, &hidden_, &foot_, &blank_}) counts->assign(memory.width, 0);
  std::uint16_t floor = 0;  // the lowest of all rows so far
  for (top_ = memory.height; top_ > 0; --top_) {
    const std::uint16_t lowest = learned(memory, top_ - 1);
    floor = std::max(floor, lowest);
    if (lowest == 0 || lowest < least_floor(floor)) return;
    count_row(memory, top_ - 1);
  }
}

/// The lowest ground return of a row, as far as it is remembered.
std::uint16_t FloorStrip::learned(const PixelMemory& memory, std::size_t row) {
  const std::uint16_t* pixels = memory.row(row);
  using Code = std::int16_t;  // codes have 15 bits, and every vector unit compares these fastest
  Code now = 0;
  for (std::size_t i = 1, width = memory.width; i < width; ++i) {
    const auto left = static_cast<Code>(PixelMemory::code_of(pixels[i - 1]));
    const auto right = static_cast<Code>(PixelMemory::code_of(pixels[i]));
    const Code least = std::min(left, right), most = std::max(left, right);  // one alone may be noise
    const Code ground = most < Code{PixelMemory::elsewhere} ? least : Code{0};
    now = std::max(now, ground);
  }
  std::uint16_t& lowest = lowest_[row];
  const bool any = now >= PixelMemory::ground_zero;  // where the row is blank, nothing speaks against what was seen
  if (any) lowest = static_cast<std::uint16_t>(std::max<int>(now, lowest - forgotten));
  return lowest;
}

bool FloorStrip::is_reached(const PixelMemory& memory, std::size_t column) const {
  std::size_t row = top_;
  while (row > 0 && PixelMemory::is_ground(PixelMemory::code_of(memory.row(row - 1)[column]))) --row;
  if (row == 0) return false;
  const std::uint16_t pixel = memory.row(row - 1)[column];
  return PixelMemory::is_now(pixel) && PixelMemory::is_near(PixelMemory::code_of(pixel));
}

void FloorStrip::count_row(const PixelMemory& memory, std::size_t row) {
  const std::uint16_t* pixels = memory.row(row);
  const auto [first, last] = span_of_returns(pixels, memory.width);
  const auto floor = static_cast<std::int16_t>(least_floor(lowest_[row]));
  Count *shown = shown_.data(), *hidden = hidden_.data(), *foot = foot_.data(), *blank = blank_.data();
  for (std::size_t i = first; i < last; ++i) {
    const auto code = static_cast<std::int16_t>(PixelMemory::code_of(pixels[i]));
    const Count now = PixelMemory::is_now(pixels[i]), seen_past = code >= floor, ever = code != PixelMemory::nothing;
    shown[i] = static_cast<Count>(shown[i] + (now & seen_past));
    hidden[i] = static_cast<Count>(hidden[i] + (ever & ~(now & seen_past)));
    foot[i] = static_cast<Count>(foot[i] + (now & ~seen_past));
    blank[i] = static_cast<Count>(blank[i] + (now ^ 1));
  }
}

bool FloorStrip::is_covered() const {
  const std::size_t width = blank_.size(), post = std::max<std::size_t>(2, width / post_share_of_width);
  return any_adjacent(post, width,
                      [this](std::size_t i) { return blank_[i] >= 2 && blank_[i] >= 3 * (shown_[i] + foot_[i]); });
}

}  // namespace safety_control_cloud
