// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <random>

#include "../../../safety_control_cloud/core/input/runs.hpp"
#include "../../../safety_control_cloud/core/look/outlook.hpp"

namespace safety_control_cloud {

/// How something random is looked at. What derives from it draws in an order of its own, always the same: a seed stands
/// for a case.
struct RandomCase {
  Corridor corridor;
  std::optional<Placement> placement;
  Rows rows = Rows::Joined;

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

  void choose_rows() { rows = pick({Rows::Joined, Rows::Apart}); }

  std::mt19937_64 random_;
};

}  // namespace safety_control_cloud
