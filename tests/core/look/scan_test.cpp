// SPDX-License-Identifier: BSD-3-Clause
// One pass == PCL on 10,000 random clouds, with every instruction set of this machine. CMake builds this test twice:
// the second time with the kernel as it is without Highway, which leaves the library's out.
#include "../../../safety_control_cloud/core/look/kernel/scan.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "../../../safety_control_cloud/core/input/point_reader.hpp"
#include "../../../safety_control_cloud/core/look/meaning.hpp"
#include "../../../safety_control_cloud/core/look/passthrough.hpp"
#include "random_cloud.hpp"
#include "same_sight.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::uint64_t clouds = 10000;

INSTANTIATE_TEST_SUITE_P(With, InstructionSet, testing::ValuesIn(instruction_sets()),
                         [](const auto& info) { return info.param; });

TEST_P(InstructionSet, SeesInEveryCloudWhatPclSees) {
  for (std::uint64_t seed = 0; seed < clouds; ++seed) {
    const RandomCloud cloud(seed);
    const Sight seen = seen_by(look, cloud.view, cloud), expected = seen_by(passthrough, cloud.view, cloud);
    ASSERT_TRUE(same(seen, expected)) << "seed " << seed << ": " << words(seen) << "; PCL: " << words(expected);
  }
}

/// What scan() and inside_of() say of a run, a point at a time.
struct Singly {
  Counts counts;
  float nearest = inf;
  std::vector<std::uint32_t> columns;

  Singly(const Run& run, const Outlook& outlook) {
    std::uint32_t column = 0;
    for_each_point(run.points, [&](float x, float y, float z) {
      const bool returns = is_return(x, y, z, outlook.corridor);
      const Point placed = returns ? outlook.placed(x, y, z) : Point();
      const bool inside = returns && is_inside(placed, outlook.corridor);
      counts += {returns, inside, is_too_close(x, y, z, outlook)};
      if (inside) nearest = std::min(nearest, placed.z);
      if (inside) columns.push_back(column);
      ++column;
    });
  }
};

TEST_P(InstructionSet, CountsAndListsWhatEachPointMeans) {
  for (std::uint64_t seed = 0; seed < clouds / 10; ++seed) {
    const RandomCloud cloud(seed);
    const Outlook outlook(cloud.corridor, cloud.placement);
    const Runs runs(cloud.view, cloud.rows);
    std::vector<float> nearest(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const Counts counts = scan(runs, i, i + 1, outlook, nearest.data());
      const Inside inside = inside_of(runs[i], outlook);
      const Singly expected(runs[i], outlook);
      ASSERT_EQ(counts.returns, expected.counts.returns) << "seed " << seed;
      ASSERT_EQ(counts.inside, expected.counts.inside) << "seed " << seed;
      ASSERT_EQ(counts.too_close, expected.counts.too_close) << "seed " << seed;
      ASSERT_EQ(nearest[i], expected.nearest) << "seed " << seed;
      const auto* columns = inside.columns.data();
      ASSERT_EQ(std::vector<std::uint32_t>(columns, columns + inside.size), expected.columns) << "seed " << seed;
    }
  }
}

bool holds(const Region& region, const Point& placed) {
  return placed.x >= region.x_min && placed.x <= region.x_max && placed.y >= region.y_min && placed.y <= region.y_max &&
         placed.z >= region.z_min && placed.z <= region.z_max;
}

/// Behind the camera too.
TEST_P(InstructionSet, GathersWhereEachReturnOfARegionLies) {
  const Region region{-1.5f, 1.0f, -0.6f, 0.3f, -2.5f, 3.0f};
  std::size_t gathered = 0;
  for (std::uint64_t seed = 0; seed < clouds / 10; ++seed) {
    const RandomCloud cloud(seed);
    const Outlook outlook(cloud.corridor, cloud.placement);
    const Runs runs(cloud.view, cloud.rows);
    Places places;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      gather(runs[i], outlook, region, places);
      std::size_t found = 0;
      for_each_point(runs[i].points, [&](float x, float y, float z) {
        if (!is_return(x, y, z, outlook.corridor) || !holds(region, outlook.placed(x, y, z))) return;
        const Point place = outlook.placed(x, y, z);
        ASSERT_LT(found, places.size) << "seed " << seed;
        ASSERT_EQ(places.x[found], place.x) << "seed " << seed;
        ASSERT_EQ(places.y[found], place.y) << "seed " << seed;
        ASSERT_EQ(places.z[found], place.z) << "seed " << seed;
        ++found;
      });
      ASSERT_EQ(places.size, found) << "seed " << seed;
      gathered += found;
    }
  }
  EXPECT_GT(gathered, clouds);
}

TEST_P(InstructionSet, ACloudMayBeginAtAnyAddress) {
  for (std::uint64_t seed = 0; seed < clouds / 10; ++seed) {
    const RandomCloud cloud(seed);
    const std::size_t before = 1 + seed % 3;
    std::vector<std::uint8_t> moved(before);
    moved.insert(moved.end(), cloud.bytes.begin(), cloud.bytes.end());
    moved.shrink_to_fit();
    CloudView view = cloud.view;
    view.bytes = moved.data() + before;
    ASSERT_TRUE(same(seen_by(look, view, cloud), seen_by(look, cloud.view, cloud))) << "seed " << seed;
  }
}

TEST_P(InstructionSet, AskingForTheCropDoesNotChangeWhatIsSeen) {
  for (std::uint64_t seed = 0; seed < clouds / 10; ++seed) {
    const RandomCloud cloud(seed);
    Sight with = seen_by(look, cloud.view, cloud, Crop::Keep), without = seen_by(look, cloud.view, cloud, Crop::Skip);
    with.crop.reset();
    ASSERT_TRUE(same(with, without)) << "seed " << seed;
  }
}

bool same_places(const Places& one, const Places& other) {
  const auto same = [&](const auto& a, const auto& b) { return std::equal(a.data(), a.data() + one.size, b.data()); };
  return one.size == other.size && same(one.x, other.x) && same(one.y, other.y) && same(one.z, other.z);
}

TEST_P(InstructionSet, WhatGoesAlongsideIsGatheredRunByRunAndChangesNothing) {
  const Region region{-1.5f, 1.0f, -0.6f, 0.3f, -2.5f, 3.0f};
  for (std::uint64_t seed = 0; seed < clouds / 10; ++seed) {
    const RandomCloud cloud(seed), another(seed + 1);
    const Outlook outlook(cloud.corridor, cloud.placement), other(another.corridor, another.placement);
    const Runs runs(cloud.view, cloud.rows);
    std::size_t taken = 0;
    const Alongside alongside{other, region, [&](const Places& places) {
                                Places expected;
                                gather(runs[taken++], other, region, expected);
                                EXPECT_TRUE(same_places(places, expected)) << "seed " << seed;
                              }};
    const Sight with = look_alongside(cloud.view, outlook, Crop::Keep, cloud.rows, &alongside);
    ASSERT_TRUE(same(with, look(cloud.view, outlook, Crop::Keep, cloud.rows))) << "seed " << seed;
    ASSERT_EQ(taken, runs.size()) << "seed " << seed;
  }
}

/// Of the smallest of the grids that holds a place.
std::int32_t cell_of(float x, float y, const std::vector<CellGrid>& grids) {
  for (const CellGrid& grid : grids) {
    if (!(std::abs(x) < grid.extent && std::abs(y) < grid.extent)) continue;
    const auto column = static_cast<std::int32_t>((x + grid.extent) * grid.per_metre);
    return grid.first + static_cast<std::int32_t>((y + grid.extent) * grid.per_metre) * grid.side + column;
  }
  return in_no_cell;
}

TEST_P(InstructionSet, FindsTheCellInWhichEachPlaceLies) {
  const std::vector<CellGrid> grids = {{0.4f, 250.0f, 201, 1}, {1.3f, 90.0f, 235, 40402}, {4.0f, 32.0f, 257, 95627}};
  std::mt19937 random(20261124);
  const std::vector<float> odd = {nan, inf, -inf, 0.0f, 0.4f, -0.4f, 1.3f, -4.0f, 1e30f, -1e-45f};
  std::size_t held = 0;
  for (int times = 0; times < 1000; ++times) {
    Places places;
    places.size = random() % (Runs::longest + 1);
    std::uniform_real_distribution<float> anywhere(-1.0f, 1.0f);
    const float far = std::array<float, 3>{0.5f, 1.5f, 5.0f}[random() % 3];
    for (std::size_t i = 0; i < places.size; ++i) {
      places.x[i] = random() % 16 == 0 ? odd[random() % odd.size()] : far * anywhere(random);
      places.z[i] = random() % 16 == 0 ? odd[random() % odd.size()] : far * anywhere(random);
    }
    CellNumbers cells;
    find_cells(places, grids, cells);
    for (std::size_t i = 0; i < places.size; ++i) {
      ASSERT_EQ(cells[i], cell_of(places.z[i], -places.x[i], grids)) << places.z[i] << ", " << -places.x[i];
      held += cells[i] != in_no_cell;
    }
  }
  EXPECT_GT(held, 100000u);
}

TEST_P(InstructionSet, OfAManyEquallyNearPointsTheFirstIsTheNearest) {
  std::vector<Xyz> points(10 * Runs::longest, {0.0f, 0.0f, 2.0f});
  for (std::size_t first : {std::size_t{0}, Runs::longest - 1, Runs::longest, 5 * Runs::longest + 7}) {
    std::vector<Xyz> some = points;
    for (std::size_t i = first; i < some.size(); ++i) some[i] = {static_cast<float>(i - first) * 1e-6f, 0.1f, 1.0f};
    EXPECT_EQ(look(view_of(some), {}).nearest->point.x, 0.0f) << first;
  }
}

constexpr std::array<WayToLook, 2> both_methods = {&look, &passthrough};

/// A camera turned aside by 45 degrees: what is 3e38 m ahead of it and as far beside lies straight ahead of the robot,
/// and farther than a float can tell.
Placement looking_aside() {
  constexpr float cos_45 = 0.70710678f;
  Placement placement;
  placement.rows = {{{cos_45, 0, -cos_45, 0}, {0, 1, 0, 0}, {cos_45, 0, cos_45, 0}}};
  return placement;
}
const Outlook aside({}, looking_aside());
const std::vector<Xyz> overflowing(40, {3e38f, 0.0f, 3e38f});

TEST_P(InstructionSet, ReturnsThatOverflowWhenPlacedAreNotInside) {
  for (const WayToLook method : both_methods) {
    const Sight sight = method(view_of(overflowing), aside, Crop::Keep, Rows::Joined);
    EXPECT_EQ(sight.returns, overflowing.size());
    EXPECT_EQ(sight.inside, std::size_t{0});
    EXPECT_TRUE(sight.crop->empty());
    EXPECT_FALSE(sight.nearest);
  }
}

TEST(InstructionSets, ThereIsAlwaysOne) { EXPECT_FALSE(instruction_sets().empty()); }

TEST(InstructionSets, OneThatTheMachineLacksIsRefused) {
  EXPECT_THROW(use_instruction_set("ABACUS"), std::invalid_argument);
}

TEST(Runs, RowsOfNothingAreNoRuns) {
  CloudView view;
  view.height = std::size_t{1} << 32;
  EXPECT_EQ(Runs(view).size(), std::size_t{0});
}

}  // namespace
}  // namespace safety_control_cloud
