// SPDX-License-Identifier: BSD-3-Clause
// One pass == PCL on 10,000 random clouds, with every instruction set of this machine. CMake builds this test twice:
// the second time with scan_portable.cpp among its own sources, which leaves the library's scan() out.
#include "../../safety_control_cloud/core/scan.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "../../safety_control_cloud/core/passthrough.hpp"
#include "random_cloud.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::uint64_t clouds = 10000;

bool same_bits(const Point& a, const Point& b) { return std::memcmp(a.data, b.data, 3 * sizeof(float)) == 0; }

bool same(const Sight& a, const Sight& b) {
  if (a.inside != b.inside || a.too_close != b.too_close || a.returns != b.returns || a.total != b.total) return false;
  if (a.lost != b.lost) return false;
  if (a.nearest.has_value() != b.nearest.has_value()) return false;
  if (a.nearest && !same_bits(a.nearest->point, b.nearest->point)) return false;
  if ((a.crop == nullptr) != (b.crop == nullptr)) return false;
  return !a.crop || std::equal(a.crop->begin(), a.crop->end(), b.crop->begin(), b.crop->end(), same_bits);
}

std::string words(const Sight& sight) {
  return std::to_string(sight.inside) + " inside, " + std::to_string(sight.too_close) + " too close, " +
         std::to_string(sight.returns) + " returns of " + std::to_string(sight.total) + ", " +
         std::to_string(sight.lost) + " lost, nearest " +
         (sight.nearest ? std::to_string(sight.nearest->distance()) : "none");
}

class InstructionSet : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { use_instruction_set(GetParam()); }
  void TearDown() override { use_instruction_set(""); }
};

INSTANTIATE_TEST_SUITE_P(With, InstructionSet, testing::ValuesIn(instruction_sets()),
                         [](const auto& info) { return info.param; });

/// What one method sees of a cloud, and what the pixels remember afterwards.
struct Seen {
  Sight sight;
  std::vector<std::uint16_t> pixels;
};

Seen seen_by(Sight (*method)(const CloudView&, const Corridor&, const Gaze&), const RandomCloud& cloud, Crop crop) {
  PixelMemory memory = cloud.memory;
  Gaze gaze;
  gaze.crop = crop;
  if (cloud.placement) gaze.placement = &*cloud.placement;
  if (memory.distance > 0.0f) gaze.memory = &memory;
  const Sight sight = method(cloud.view, cloud.corridor, gaze);
  return {sight, memory.pixels};
}

TEST_P(InstructionSet, SeesInEveryCloudWhatPclSees) {
  for (std::uint64_t seed = 0; seed < clouds; ++seed) {
    const RandomCloud cloud(seed);
    const Seen seen = seen_by(look, cloud, Crop::Keep), expected = seen_by(passthrough, cloud, Crop::Keep);
    ASSERT_TRUE(same(seen.sight, expected.sight))
        << "seed " << seed << ": " << words(seen.sight) << "; PCL: " << words(expected.sight);
    ASSERT_EQ(seen.pixels, expected.pixels) << "seed " << seed;
  }
}

TEST_P(InstructionSet, AskingForTheCropDoesNotChangeWhatIsSeen) {
  for (std::uint64_t seed = 0; seed < clouds / 10; ++seed) {
    const RandomCloud cloud(seed);
    Seen with = seen_by(look, cloud, Crop::Keep), without = seen_by(look, cloud, Crop::Skip);
    with.sight.crop.reset();
    ASSERT_TRUE(same(with.sight, without.sight)) << "seed " << seed;
    ASSERT_EQ(with.pixels, without.pixels) << "seed " << seed;
  }
}

TEST_P(InstructionSet, OfAManyEquallyNearPointsTheFirstIsTheNearest) {
  std::vector<Xyz> points(10 * Runs::longest, {0.0f, 0.0f, 2.0f});
  for (std::size_t first : {std::size_t{0}, Runs::longest - 1, Runs::longest, 5 * Runs::longest + 7}) {
    std::vector<Xyz> some = points;
    for (std::size_t i = first; i < some.size(); ++i) some[i] = {static_cast<float>(i - first) * 1e-6f, 0.1f, 1.0f};
    EXPECT_EQ(look(view_of(some), {}).nearest->point.x, 0.0f) << first;
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
