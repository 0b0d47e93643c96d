// SPDX-License-Identifier: BSD-3-Clause
// Each instruction set against a loop over single pixels.
#include "../../../safety_control_cloud/core/memory/kernel/lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "../../../safety_control_cloud/core/look/kernel/scan.hpp"
#include "../../../safety_control_cloud/core/look/outlook.hpp"
#include "../../../safety_control_cloud/core/memory/likeness.hpp"

namespace safety_control_cloud::lines {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

struct Row {
  std::vector<float> x, y, z;

  explicit Row(std::size_t size = 0) : x(size), y(size), z(size) {}
  PixelsOfRow pixels() const { return {x.data(), y.data(), z.data(), z.size()}; }
};

class Lines : public testing::TestWithParam<std::string> {
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
    place(from.pixels(), 0.0f, Placement{}, placed.x.data(), placed.y.data(), placed.z.data());
    return placed;
  }

  Surrounding surrounding() { return {{}, Point(0.0f, between(-0.2f, 0.2f), between(-0.2f, 0.2f)), 0.78f}; }

  std::mt19937 random_{20261124};
  static constexpr int times = 2000;
};

bool same(float one, float other) { return one == other || (std::isnan(one) && std::isnan(other)); }

TEST_P(Lines, ReadPointsThatLieApartUpToTheEndOfTheirBytes) {
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

TEST_P(Lines, LookAroundAPixelAsAtEachOfTheNine) {
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

TEST_P(Lines, PlacesWhatReturnsAsThePlacementDoes) {
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

TEST_P(Lines, TellTheNearestOfSomePointsAsTheDistanceBetweenTwoDoes) {
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

INSTANTIATE_TEST_SUITE_P(InstructionSets, Lines, testing::ValuesIn(instruction_sets()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace safety_control_cloud::lines
