// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/connected.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>

#include "../../../safety_control_cloud/core/look/kernel/scan.hpp"
#include "../../../safety_control_cloud/core/memory/inner_pixels.hpp"

namespace safety_control_cloud {
namespace {

constexpr float jump = 0.06f;

using Index = NearPixels::Index;
using Members = std::vector<Index>;

/// Pixel by pixel, as it is said.
struct Singly {
  const NearPixels& found;
  std::vector<Index> thing;          ///< of each slot, the first pixel of its thing
  std::vector<std::set<int>> sides;  ///< on which each touches another: 0 left, 1 right, 2 above, 3 below

  explicit Singly(const NearPixels& pixels) : found(pixels), thing(pixels.ahead.size()), sides(thing.size()) {
    for (Index i = 0; i < thing.size(); ++i) thing[i] = i;
    const auto beside = [&](Index i, int down, int right) -> std::optional<Index> {
      const int line = static_cast<int>(found.line_of(i)) + down, slot = static_cast<int>(found.slot_of(i)) + right;
      if (line < 0 || slot < 0 || slot >= static_cast<int>(found.slots)) return std::nullopt;
      const auto there = static_cast<Index>(line * static_cast<int>(found.slots) + slot);
      const bool goes_on = std::abs(found.ahead[i] - found.ahead[there]) <= jump;
      return goes_on ? std::optional(there) : std::nullopt;
    };
    for (Index i = 0; i < thing.size(); ++i) {
      for (const int left : {-1, -2}) {
        const auto other = beside(i, 0, left);
        if (!other) continue;
        join(i, *other, 0, 1);
        break;
      }
      for (const int up : {-1, -2}) {
        const int line = static_cast<int>(found.line_of(i)) + up;
        if (line < 0 || found.row_of(i) - found.rows[static_cast<std::size_t>(line)] > 2 * found.row_step) break;
        if (const auto over = beside(i, up, 0)) {
          join(i, *over, 2, 3);
          break;
        }
        const auto left = beside(i, up, -1), right = beside(i, up, 1);
        if (left) join(i, *left);
        if (right) join(i, *right);
        if (left || right) break;
      }
    }
  }

  void join(Index one, Index other, int side = -1, int opposite = -1) {
    if (side >= 0) sides[one].insert(side), sides[other].insert(opposite);
    const Index from = std::max(thing[one], thing[other]), to = std::min(thing[one], thing[other]);
    std::replace(thing.begin(), thing.end(), from, to);
  }
};

/// A few surfaces at random, with holes, in lines of which some are far from the next. Each has a pixel at least.
NearPixels drawn(std::mt19937& random) {
  const auto share = [&] { return std::uniform_real_distribution<float>(0.0f, 1.0f)(random); };
  NearPixels found;
  found.slots = 1 + random() % 40;
  found.row_step = 1 + random() % 4;
  const std::size_t lines = random() % 12;
  const float holes = share();
  std::size_t row = random() % 5;
  std::vector<float> surface(found.slots, 0.5f);
  for (std::size_t line = 0; line < lines; ++line, row += 1 + random() % (3 * found.row_step)) {
    found.rows.push_back(row);
    const std::size_t always = random() % found.slots;
    for (std::size_t slot = 0; slot < found.slots; ++slot) {
      if (share() < 0.1f) surface[slot] = 0.4f + 0.5f * share();
      if (slot > 0 && share() < 0.7f) surface[slot] = surface[slot - 1] + 0.1f * (share() - 0.5f);
      const bool is_hole = slot != always && share() < holes;
      found.ahead.push_back(is_hole ? std::numeric_limits<float>::quiet_NaN() : surface[slot]);
    }
  }
  return found;
}

class Connects : public testing::TestWithParam<std::string> {
  void SetUp() override { use_instruction_set(GetParam()); }
  void TearDown() override { use_instruction_set(""); }
};

TEST_P(Connects, ThePixelsThatAreOnePixelByPixel) {
  std::mt19937 random(20261123);
  std::size_t inner = 0, several = 0;
  for (int times = 0; times < 3000; ++times) {
    const NearPixels found = drawn(random);
    const Singly expected(found);
    const Connected connected(found, jump);
    std::map<Index, Members> things;  // by the first of each
    for (Index i = 0; i < expected.thing.size(); ++i)
      if (!std::isnan(found.ahead[i])) things[expected.thing[i]].push_back(i);
    ASSERT_EQ(connected.things().size(), things.size()) << times;
    auto thing = connected.things().begin();
    for (const auto& [first, members] : things) ASSERT_EQ(pixels_of(found, *thing++), members) << times;
    for (Index i = 0; i < expected.sides.size(); ++i) {
      ASSERT_EQ(connected.touched()[i] == lines::AllSides, expected.sides[i].size() == 4) << times;
      inner += expected.sides[i].size() == 4;
    }
    several += things.size() > 1;
  }
  EXPECT_GT(inner, 1000u);
  EXPECT_GT(several, 1000u);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, Connects, testing::ValuesIn(instruction_sets()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace safety_control_cloud
