// SPDX-License-Identifier: BSD-3-Clause
#include "lost_pixels.hpp"

#include <algorithm>
#include <cstdint>

namespace safety_control_cloud {
namespace {

/// Lost pixels in this share of the cloud, and more of them than still return near, are an obstacle, not its edge.
constexpr std::size_t obstacle_share = 1000;
/// The edge of what stands upright leans in the picture, as the robot pitches, by at most this share of its width: what
/// a column shows near the edge reaches the floor in another one.
constexpr std::size_t edge_share = 128;

bool is_lost(std::uint16_t pixel) { return PixelMemory::is_near(pixel); }  // near, and without the flag `now`

/// The nearest pixel of those 2 x 2 of two rows that are all lost; not near if there are none.
std::uint16_t nearest_lost_block(const std::uint16_t* above, const std::uint16_t* below, std::size_t width) {
  std::uint16_t nearest = PixelMemory::nothing;
  for (std::size_t i = 1; i < width; ++i) {
    const std::uint16_t farthest = std::max(std::max(above[i - 1], above[i]), std::max(below[i - 1], below[i]));
    const std::uint16_t least = std::min(std::min(above[i - 1], above[i]), std::min(below[i - 1], below[i]));
    nearest = std::min(nearest, is_lost(farthest) ? least : PixelMemory::nothing);
  }
  return nearest;
}

/// How many lost pixels it lets go.
std::size_t release(PixelMemory& memory, const std::vector<std::size_t>& columns) {
  std::size_t released = 0;
  if (columns.empty()) return released;
  for (std::size_t row = 0; row < memory.height; ++row) {
    if (!PixelMemory::is_near(memory.near.nearest_lost[row])) continue;
    for (const std::size_t i : columns) {
      std::uint16_t& pixel = memory.row(row)[i];
      if (!is_lost(pixel)) continue;
      pixel = PixelMemory::elsewhere;
      ++released;
    }
  }
  return released;
}

}  // namespace

std::size_t LostPixels::forgive(PixelMemory& memory, const FloorStrip& floor, const Sight& sight) {
  hid_floor_.resize(memory.width, false);
  const bool something_near = sight.nearest && sight.nearest->distance() < memory.distance;
  if (sight.lost == 0 && !something_near) return 0;
  note_what_hides_floor(memory, floor);
  return sight.lost - release(memory, columns_with_floor_again(memory, floor));
}

void LostPixels::note_what_hides_floor(const PixelMemory& memory, const FloorStrip& floor) {
  for (std::size_t i = 0; i < memory.width; ++i) hid_floor_[i] = hid_floor_[i] && !memory.is_near_now(i);
  const std::size_t edge = std::max<std::size_t>(1, memory.width / edge_share);
  for (std::size_t i = 0; i < memory.width; ++i) {
    if (!memory.is_near_now(i)) continue;
    const auto [shown, hidden, foot, blank] = floor.column(i);
    const bool hides = hidden > 0 && 4 * hidden >= shown + hidden;
    if (!hides && !floor.is_reached(memory, i)) continue;
    const std::size_t first = i - std::min(edge, i), last = std::min(i + edge, memory.width - 1);
    for (std::size_t j = first; j <= last; ++j) hid_floor_[j] = hid_floor_[j] || memory.is_near_now(j);
  }
}

std::vector<std::size_t> LostPixels::columns_with_floor_again(const PixelMemory& memory, const FloorStrip& floor) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < memory.width; ++i) {
    const auto [shown, hidden, foot, blank] = floor.column(i);
    const bool floor_again = !memory.is_near_now(i) && shown > 0 && 8 * hidden <= shown;
    if (!hid_floor_[i] || !floor_again) continue;
    hid_floor_[i] = false;
    free.push_back(i);
  }
  return free;
}

std::optional<Loss> LostPixels::judge(const PixelMemory& memory, std::size_t lost, std::size_t total,
                                      double near_distance) const {
  if (lost == 0) return std::nullopt;
  const std::uint16_t limit = PixelMemory::near_code(static_cast<float>(near_distance));
  std::uint16_t nearest = limit;
  for (std::size_t row = 1; row < memory.height; ++row) {
    const auto [nearer, farther] = std::minmax(memory.near.nearest_lost[row - 1], memory.near.nearest_lost[row]);
    if (nearer >= nearest || !PixelMemory::is_near(farther)) continue;
    nearest = std::min(nearest, nearest_lost_block(memory.row(row - 1), memory.row(row), memory.width));
  }
  if (nearest == limit) return std::nullopt;
  const bool whole = lost > memory.near.now && lost * obstacle_share >= total;
  return Loss{Cause::NearLoss, remembered_at(PixelMemory::distance_of_near(nearest)), whole,
              "an obstacle has stopped returning and nothing is seen behind it"};
}

}  // namespace safety_control_cloud
