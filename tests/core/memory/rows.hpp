// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "../../../safety_control_cloud/core/look/kernel/scan.hpp"
#include "../../../safety_control_cloud/core/memory/kernel/points.hpp"

namespace safety_control_cloud {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

struct Row {
  std::vector<float> x, y, z;

  explicit Row(std::size_t size = 0) : x(size), y(size), z(size) {}
  points::PixelsOfRow pixels() const { return {x.data(), y.data(), z.data(), z.size()}; }
};

/// Whose name is the parameter; rows at random.
class InEachInstructionSet : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { use_instruction_set(GetParam()); }
  void TearDown() override { use_instruction_set(""); }

  float between(float least, float most) { return std::uniform_real_distribution<float>(least, most)(random_); }

  /// Of a camera: most returns are somewhere near the corridor, some coordinates are no numbers.
  Row row() {
    Row row(random_() % 200);
    for (auto* values : {&row.x, &row.y, &row.z})
      for (float& value : *values) {
        value = between(-0.4f, 1.4f);
        if (between(0.0f, 1.0f) < 0.05f) value = nothing;
        if (between(0.0f, 1.0f) < 0.02f) value = between(0.0f, 1.0f) < 0.5f ? infinity : -infinity;
        if (between(0.0f, 1.0f) < 0.02f) value = 0.0f;
      }
    return row;
  }

  /// Of a row that is placed: where there is any pixel, all of it is finite.
  Row placed_row() {
    const Row from = row();
    Row placed = from;
    points::place(from.pixels(), 0.0f, Placement{}, placed.x.data(), placed.y.data(), placed.z.data());
    return placed;
  }

  std::mt19937 random_{20261124};
  static constexpr int times = 2000;
};

inline bool same(float one, float other) { return one == other || (std::isnan(one) && std::isnan(other)); }

}  // namespace safety_control_cloud
