// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <random>

#include "../../../safety_control_cloud/core/look/corridor.hpp"

namespace safety_control_cloud {

/// How something random is looked at. What derives from it draws in an order of its own, always the same: a seed stands
/// for a case.
struct RandomCase {
  Corridor corridor;
  std::optional<Placement> placement;
  PixelMemory memory;  ///< as what came before may have left it; not kept up if its distance is 0

 protected:
  explicit RandomCase(std::uint64_t seed) : random_(seed) {}

  template <class Value>
  Value pick(std::initializer_list<Value> choices) {
    return choices.begin()[random_() % choices.size()];
  }
  double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

  void choose_placement() {
    if (random_() % 4 > 0) return;
    placement.emplace();
    for (auto& row : placement->rows) {
      for (float& value : row) value += static_cast<float>(0.4 * share() - 0.2);
    }
  }

  void choose_memory(std::initializer_list<float> distances, const View& view) {
    memory.distance = pick(distances);
    memory.width = width_of(view);
    memory.height = height_of(view);
    for (std::size_t i = 0; i < size_of(view); ++i) {
      const int near = static_cast<int>(random_() % PixelMemory::elsewhere);
      const int code = pick({near, int{PixelMemory::elsewhere}, int{PixelMemory::nothing}});
      memory.pixels.push_back(static_cast<std::uint16_t>(code | pick({0, int{PixelMemory::now}})));
    }
  }

  std::mt19937_64 random_;
};

}  // namespace safety_control_cloud
