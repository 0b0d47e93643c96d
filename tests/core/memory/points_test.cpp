// SPDX-License-Identifier: BSD-3-Clause
// Each instruction set against a loop over single pixels.
#include "../../../safety_control_cloud/core/memory/kernel/points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "../../../safety_control_cloud/core/look/outlook.hpp"
#include "../../../safety_control_cloud/core/memory/likeness.hpp"
#include "rows.hpp"

namespace safety_control_cloud::points {
namespace {

using Points = InEachInstructionSet;

TEST_P(Points, ReadPointsThatLieApartUpToTheEndOfTheirBytes) {
  for (int i = 0; i < times; ++i) {
    const Row from = row();
    const std::size_t size = from.z.size(), apart = 3 * sizeof(float) + random_() % 90;
    std::vector<std::uint8_t> bytes(size == 0 ? 0 : (size - 1) * apart + 3 * sizeof(float));
    for (std::size_t j = 0; j < size; ++j) {
      const float xyz[] = {from.x[j], from.y[j], from.z[j]};
      std::memcpy(bytes.data() + j * apart, xyz, sizeof xyz);
    }
    Row to(size);
    read({bytes.data(), apart, size}, to.x.data(), to.y.data(), to.z.data());
    for (std::size_t j = 0; j < size; ++j)
      ASSERT_TRUE(same(to.x[j], from.x[j]) && same(to.y[j], from.y[j]) && same(to.z[j], from.z[j]));
  }
}

TEST_P(Points, LookAroundAPixelAsAtEachOfTheNine) {
  for (int i = 0; i < times; ++i) {
    const std::size_t apart = 3 * sizeof(float) + random_() % 30, rows_apart = 4 * apart;
    std::vector<std::uint8_t> bytes(2 * rows_apart + 3 * apart + sizeof(float));
    std::array<float, 9> expected;
    for (std::size_t j = 0; j < expected.size(); ++j) {
      float xyz[3];
      for (float& value : xyz) {
        value = between(-0.4f, 1.4f);
        if (between(0.0f, 1.0f) < 0.1f) value = between(0.0f, 1.0f) < 0.5f ? infinity : nothing;
      }
      std::memcpy(bytes.data() + j / 3 * rows_apart + j % 3 * apart, xyz, sizeof xyz);
      const bool returns = std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]) && xyz[2] > 0.1f;
      expected[j] = returns ? xyz[2] : nothing;
    }
    const auto z = around({bytes.data(), apart, rows_apart}, 0.1f);
    for (std::size_t j = 0; j < expected.size(); ++j) ASSERT_TRUE(same(z[j], expected[j]));
  }
}

TEST_P(Points, PlacesWhatReturnsAsThePlacementDoes) {
  const Placement turned{{{{0.96f, -0.28f, 0.0f, 0.05f}, {0.28f, 0.96f, 0.0f, -0.1f}, {0.0f, 0.0f, 1.0f, 0.2f}}}};
  for (int i = 0; i < times; ++i) {
    const Row from = row();
    const auto placement = i % 2 ? std::optional(turned) : std::nullopt;
    Row to = from;
    place(from.pixels(), 0.1f, placement, to.x.data(), to.y.data(), to.z.data());
    for (std::size_t j = 0; j < from.z.size(); ++j) {
      const bool finite = std::isfinite(from.x[j]) && std::isfinite(from.y[j]) && std::isfinite(from.z[j]);
      const bool returns = finite && from.z[j] > 0.1f;
      ASSERT_EQ(std::isnan(to.z[j]), !returns);
      if (!returns) continue;
      const Point expected = Outlook({}, placement).placed(from.x[j], from.y[j], from.z[j]);
      ASSERT_TRUE(to.x[j] == expected.x && to.y[j] == expected.y && to.z[j] == expected.z);
    }
  }
}

TEST_P(Points, TellTheNearestOfSomePointsAsTheDistanceBetweenTwoDoes) {
  for (int i = 0; i < times; ++i) {
    Row row(random_() % 200);
    for (auto* values : {&row.x, &row.y, &row.z})
      for (float& value : *values) value = between(-0.4f, 1.4f);
    const Point from(between(-0.4f, 0.4f), between(-0.4f, 0.4f), between(0.2f, 1.4f));
    float expected = 0.0225f;
    for (std::size_t j = 0; j < row.z.size(); ++j)
      expected = std::min(expected, squared_distance(from, Point(row.x[j], row.y[j], row.z[j])));
    ASSERT_EQ(least_square(row.pixels(), from, 0.0225f), expected);
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, Points, testing::ValuesIn(instruction_sets()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace safety_control_cloud::points
