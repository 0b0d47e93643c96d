// SPDX-License-Identifier: BSD-3-Clause
#include "pixel_memory.hpp"

namespace safety_control_cloud {

void PixelMemory::start_cloud() {
  near.nearest_now.assign(width, none);
  near.nearest_lost.assign(height, none);
  near.now = near.lost = 0;
}

void PixelMemory::note(std::size_t row, std::size_t column, std::size_t size) {
  const std::uint16_t* piece = pixels.data() + row * width + column;
  for (std::size_t i = 0; i < size; ++i) {
    // Near and with the flag `now` becomes less than all else, as near and without it, which is lost, was.
    const auto flipped = static_cast<std::uint16_t>(piece[i] ^ now);
    near.nearest_now[column + i] = std::min(near.nearest_now[column + i], flipped);
    near.nearest_lost[row] = std::min(near.nearest_lost[row], is_near(piece[i]) ? piece[i] : none);
    near.now += is_near(flipped);
    near.lost += is_near(piece[i]);
  }
}

}  // namespace safety_control_cloud
