// SPDX-License-Identifier: BSD-3-Clause
// Each instruction set against a loop over single pixels.
#include "../../../safety_control_cloud/core/memory/kernel/lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "rows.hpp"

namespace safety_control_cloud::lines {
namespace {

class Lines : public InEachInstructionSet {
 protected:
  Surrounding surrounding() { return {{}, Point(0.0f, between(-0.2f, 0.2f), between(-0.2f, 0.2f)), 0.78f}; }
  int below(unsigned end) { return static_cast<int>(random_() % end); }
};

TEST_P(Lines, FindWhatIsNearInTheCorridor) {
  for (int i = 0; i < times; ++i) {
    const Row seen = placed_row();
    const Surrounding around = surrounding();
    std::vector<float> ahead(seen.z.size());
    float expected_nearest = infinity;
    const float nearest = find_near(seen.pixels(), around, ahead.data());
    for (std::size_t j = 0; j < ahead.size(); ++j) {
      const float there = seen.z[j] - around.camera.z;
      const bool is_near = there > 0.0f && there < around.distance && seen.z[j] > 0.0f &&
                           around.corridor.holds(Point(seen.x[j], seen.y[j], seen.z[j]));
      ASSERT_TRUE(same(ahead[j], is_near ? there : nothing));
      if (is_near) expected_nearest = std::min(expected_nearest, there);
    }
    ASSERT_EQ(nearest, expected_nearest);
  }
}

TEST_P(Lines, FindNearGroundByItsMillimetres) {
  for (int i = 0; i < times; ++i) {
    const Row seen = placed_row();
    const Surrounding around = surrounding();
    std::vector<std::int16_t> ground(seen.z.size());
    std::vector<float> ahead_of_camera(seen.z.size());
    int expected_greatest = ReturnsNothing;
    const int greatest = find_ground(seen.pixels(), around, ground.data(), ahead_of_camera.data());
    for (std::size_t j = 0; j < ground.size(); ++j) {
      int expected = ReturnsNothing;
      if (!std::isnan(seen.z[j])) {
        const bool ahead = seen.z[j] - around.camera.z < around.distance && seen.z[j] > 0.0f;
        const bool beside = seen.x[j] < around.corridor.x_min || seen.x[j] > around.corridor.x_max;
        const float below = std::clamp(seen.y[j] - around.camera.y, 0.0f, 30.0f);
        expected = !ahead || beside || seen.y[j] < around.corridor.y_min ? ReturnsElsewhere
                   : seen.y[j] <= around.corridor.y_max                  ? ReturnsNear
                                                                         : static_cast<int>(0.5f + 1000.0f * below);
      }
      ASSERT_EQ(ground[j], expected);
      ASSERT_TRUE(same(ahead_of_camera[j], seen.z[j] - around.camera.z));
      expected_greatest = std::max(expected_greatest, expected);
    }
    ASSERT_EQ(greatest, expected_greatest);
  }
}

/// What a column knows after some rows of ground.
struct Column {
  std::int16_t lowest = no_ground, lowest_row = no_row, above = 0, first_above = no_row;

  void take(std::int16_t here, bool is_shown_twice, std::int16_t kept, std::int16_t row, const StepLimits& limits) {
    if (lowest == no_ground && here != no_ground && is_shown_twice) lowest = here, lowest_row = row;
    const int floor = std::max<int>(lowest == no_ground ? 0 : lowest, kept);
    if (here > floor - limits.step) return;
    ++above;
    first_above = std::min(first_above, row);
  }
};

TEST_P(Lines, NoteStepsFromTheLowestRowUp) {
  constexpr StepLimits limits{15, 25};
  const auto some_ground = [this] {
    const int which = below(8);
    return static_cast<std::int16_t>(which < 2 ? int{no_ground} : which < 7 ? 280 + below(60) : below(30001));
  };
  for (int i = 0; i < times; ++i) {
    const auto columns = static_cast<std::size_t>(1 + below(200));
    std::vector<std::int16_t> row(columns + 2, no_ground), under = row, kept(columns, 0);
    std::vector<std::int16_t> lowest(columns, no_ground), lowest_row = lowest, above(columns, 0), first_above = lowest;
    std::vector<Column> expected(columns);
    for (std::int16_t& one : kept) one = static_cast<std::int16_t>(below(3) == 0 ? 250 + below(80) : 0);
    for (std::int16_t number = 0; number < 8; ++number) {
      std::swap(row, under);
      for (std::size_t j = 1; j <= columns; ++j) row[j] = some_ground();
      note_steps(row.data() + 1, under.data() + 1, kept.data(), columns, number, limits,
                 {lowest.data(), lowest_row.data(), above.data(), first_above.data()});
      for (std::size_t j = 0; j < columns; ++j) {
        const int here = row[j + 1];
        const bool is_shown_twice = std::abs(here - row[j]) <= limits.same_ground ||
                                    std::abs(here - row[j + 2]) <= limits.same_ground ||
                                    std::abs(here - under[j + 1]) <= limits.same_ground;
        expected[j].take(row[j + 1], is_shown_twice, kept[j], number, limits);
        ASSERT_EQ(lowest[j], expected[j].lowest);
        ASSERT_EQ(lowest_row[j], expected[j].lowest_row);
        ASSERT_EQ(above[j], expected[j].above);
        ASSERT_EQ(first_above[j], expected[j].first_above);
      }
    }
  }
}

TEST_P(Lines, SumUpSlots) {
  const Corridor corridor;
  constexpr float border = 0.03f;
  for (int i = 0; i < times; ++i) {
    const Row row = placed_row();
    InSlots expected;
    std::vector<std::uint32_t> lowest(row.z.size(), 7), expected_lowest = lowest;
    for (std::size_t j = 0; j < row.z.size(); ++j) {
      if (std::isnan(row.z[j])) continue;
      ++expected.pixels;
      expected.nearest = std::min(expected.nearest, row.z[j]);
      expected.squares += double{row.z[j]} * double{row.z[j]};
      expected.beside = expected.beside || row.x[j] < corridor.x_min + border || row.x[j] > corridor.x_max - border ||
                        row.y[j] < corridor.y_min + border;
      expected_lowest[j] = 100 + static_cast<std::uint32_t>(j);
    }
    const SomeSlots some{row.z.data(), row.x.data(), row.y.data(), row.z.size()};
    const InSlots found = in_slots(some, corridor, border);
    note_lowest(some, 100, lowest.data());
    ASSERT_EQ(found.pixels, expected.pixels);
    ASSERT_EQ(found.nearest, expected.nearest);
    ASSERT_NEAR(found.squares, expected.squares, 1e-9);
    ASSERT_EQ(found.beside, expected.beside);
    ASSERT_EQ(lowest, expected_lowest);
  }
}

TEST_P(Lines, MarkWhatIsTouchedOnAllSides) {
  for (int i = 0; i < times; ++i) {
    const std::size_t size = random_() % 200;
    std::vector<std::uint8_t> touched(size + in_word);
    for (auto& sides : touched)
      sides = random_() % 3 ? std::uint8_t{AllSides} : static_cast<std::uint8_t>(random_() % 16);
    std::vector<std::uint64_t> inner(words_for(size)), expected(words_for(size), 0);
    mark_inner(touched.data(), size, inner.data());
    for (std::size_t j = 0; j < size; ++j)
      if (touched[j] == AllSides) expected[j / in_word] |= std::uint64_t{1} << (j % in_word);
    ASSERT_EQ(inner, expected);
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, Lines, testing::ValuesIn(instruction_sets()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace safety_control_cloud::lines
