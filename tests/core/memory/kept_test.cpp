// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/kept.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

#include "../../../safety_control_cloud/core/look/look.hpp"
#include "../../../safety_control_cloud/core/memory/near_loss.hpp"
#include "../scene.hpp"

namespace safety_control_cloud {
namespace {

std::optional<Loss> judged(NearLoss& memory, const Scene& scene, double now = 1.0) {
  const View view = scene.view();
  const Outlook outlook;
  return memory.judge(view, look(view, outlook, Crop::Skip, memory.rows_for(view)), outlook, now, 0.0);
}

const Board near_board = {0.45f, -0.2f, 0.2f, -0.2f, 0.05f}, blind_board = {0.35f, -0.2f, 0.2f, -0.2f, 0.05f};
const Board wall = {2.0f, -3.0f, 3.0f, -3.0f, floor_y};

/// Of a memory that has lost a board.
std::string written_down() {
  NearLoss memory{NearLossLimits{}};
  judged(memory, Scene({near_board}));
  judged(memory, Scene({blind_board}));
  return memory.serialised();
}

TEST(Kept, WhatIsLostOutlivesTheProcess) {
  const std::string text = written_down();
  EXPECT_LT(text.size(), std::size_t{4096});
  NearLoss reborn{NearLossLimits{}};
  ASSERT_TRUE(reborn.restore(text));
  for (int i = 0; i < 10; ++i) {
    const auto loss = judged(reborn, Scene({blind_board}));
    ASSERT_TRUE(loss) << i;
    EXPECT_TRUE(loss->whole) << i;
    EXPECT_NEAR(loss->obstacle->distance(), 0.45, 1e-3);
  }
  for (int i = 0; i < 3; ++i) judged(reborn, Scene({wall}));
  EXPECT_FALSE(judged(reborn, Scene({wall}))) << "it has been taken away";
}

/// Four times a second; but once, of what stays where it was.
TEST(Kept, IsWrittenAnewAsSoonAsItHasMoved) {
  const auto board = [](float z, float right) { return Scene({{z, right - 0.2f, right + 0.2f, -0.2f, 0.05f}}); };
  const auto is_anew_after = [&](double seconds, const Scene& then) {
    NearLoss memory{NearLossLimits{}};
    judged(memory, board(0.45f, 0.0f), 1.0);
    const std::string text = memory.serialised();
    EXPECT_NE(text, "");
    judged(memory, then, 1.0 + seconds);
    return memory.serialised() != text;
  };
  EXPECT_FALSE(is_anew_after(0.2, board(0.42f, 0.0f)));
  EXPECT_TRUE(is_anew_after(0.25, board(0.42f, 0.0f)));
  EXPECT_TRUE(is_anew_after(0.25, board(0.45f, 0.06f)));
  EXPECT_TRUE(is_anew_after(0.25, Scene({{0.45f, -0.2f, 0.2f, -0.2f, 0.05f}, {0.44f, 0.22f, 0.24f, -0.2f, 0.05f}})));
  EXPECT_FALSE(is_anew_after(0.9, board(0.44f, 0.01f)));
  EXPECT_TRUE(is_anew_after(1.0, board(0.44f, 0.01f)));
}

TEST(Kept, WhateverItsSizeItCanBeReadAgain) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> nearness(0.41f, 0.7f), across(-0.3f, 0.3f), down(-0.2f, 0.15f);
  for (int i = 0; i < 300; ++i) {
    const auto [left, right] = std::minmax({across(random), across(random)});
    const auto [top, bottom] = std::minmax({down(random), down(random)});
    NearLoss memory{NearLossLimits{}}, reborn{NearLossLimits{}};
    judged(memory, Scene({{nearness(random), left, right, top, bottom}}));
    EXPECT_TRUE(memory.serialised().empty() || reborn.restore(memory.serialised())) << i;
  }
}

/// Strips side by side, and the narrowest of them.
struct Fringe {
  std::vector<Board> strips;
  Board thin;

  Fringe(std::size_t count, float z) : thin{z, -0.008f, 0.008f, -0.05f, 0.02f} {
    for (std::size_t i = 0; i < count; ++i) {
      const float left = -0.24f + 0.044f * static_cast<float>(i);
      if (left + 0.03f < thin.x_min - 0.01f || left > thin.x_max + 0.01f)
        strips.push_back({z, left, left + 0.03f, -0.1f, 0.05f});
    }
  }

  std::vector<Board> all() const {
    std::vector<Board> boards = strips;
    boards.push_back(thin);
    return boards;
  }
};

TEST(Kept, TheSmallestOfManyThatAreLostOutlivesTheProcessToo) {
  const Fringe near(12, 0.45f), blind(12, 0.35f);
  ASSERT_GT(near.all().size(), std::size_t{8});
  NearLoss memory{NearLossLimits{}}, reborn{NearLossLimits{}};
  for (int i = 0; i < 5; ++i) judged(memory, Scene(near.all()));
  for (int i = 0; i < 3; ++i) judged(memory, Scene(blind.all()));
  ASSERT_TRUE(reborn.restore(memory.serialised()));
  for (int i = 0; i < 30; ++i) {
    const auto loss = judged(reborn, Scene({blind.thin, wall}));
    ASSERT_TRUE(loss) << "the others have been taken away, cloud " << i;
  }
}

Remembered lost_at(std::uint16_t column) {
  Remembered thing;
  Spot spot;
  spot.column = column;
  spot.point = Point(0.0f, 0.0f, 0.5f);
  spot.share = 0.01f;
  thing.lost = {spot};
  thing.size = 0.01;
  return thing;
}

TEST(Kept, MoreThanCanBeToldAreNotForgottenInPart) {
  Kept kept{640, 480, 0.0f, {}, {}};
  for (std::uint16_t i = 0; i < 200; ++i) {
    kept.things.push_back(lost_at(i));
    const std::string text = to_text(kept);
    ASSERT_FALSE(text.empty());
    const auto read = kept_in(text);
    EXPECT_TRUE(!read || read->things.size() == kept.things.size()) << i;
    EXPECT_EQ(read.has_value(), i < 32) << i;
  }
}

TEST(Kept, WhatIsLostGoesBeforeWhatIsOnlySeen) {
  Kept kept{640, 480, 0.0f, {}, {}};
  for (std::uint16_t i = 0; i < 100; ++i) {
    kept.things.push_back(lost_at(i));
    if (i != 50) std::swap(kept.things.back().lost, kept.things.back().seen.spots);
  }
  const auto read = kept_in(to_text(kept));
  ASSERT_TRUE(read);
  const auto is_the_lost = [](const Remembered& thing) { return thing.lost.front().column == 50; };
  EXPECT_TRUE(std::any_of(read->things.begin(), read->things.end(), is_the_lost));
}

TEST(Kept, TheLittleThatIsLostOfALargeThingIsWrittenDown) {
  Kept kept{640, 480, 0.0f, {lost_at(600)}, {}};
  kept.things.front().lost.assign(8, lost_at(600).lost.front());
  kept.things.front().seen.spots.assign(500, lost_at(1).lost.front());
  const auto read = kept_in(to_text(kept));
  ASSERT_TRUE(read);
  const auto& spots = read->things.front().lost;
  const auto is_of_the_lost = [](const Spot& spot) { return spot.column == 600; };
  EXPECT_GE(std::count_if(spots.begin(), spots.end(), is_of_the_lost), 4);
  EXPECT_NEAR(size_of(spots), 5.08, 0.01);
}

TEST(Kept, KerbThatHidTheFloorOutlivesTheProcess) {
  NearLoss memory{NearLossLimits{}}, reborn{NearLossLimits{}};
  for (const float z : {0.74f, 0.70f, 0.62f}) judged(memory, Scene({{z, -0.2f, 0.2f, floor_y - 0.05f, floor_y}}));
  ASSERT_TRUE(reborn.restore(memory.serialised()));
  const auto loss = judged(reborn, Scene({{0.60f, -0.2f, 0.2f, floor_y - 0.05f, floor_y}}));
  ASSERT_TRUE(loss);
  EXPECT_EQ(loss->cause, Cause::LowObstacle);
  EXPECT_TRUE(loss->whole);
}

TEST(Kept, KerbIsWrittenDownAsSeldomAsWhatIsNear) {
  NearLoss memory{NearLossLimits{}};
  const auto after_kerb_at = [&](float z, double now) {
    judged(memory, Scene({{z, -0.2f, 0.2f, floor_y - 0.05f, floor_y}}), now);
    return memory.serialised();
  };
  after_kerb_at(0.75f, 1.0);
  const std::string first = after_kerb_at(0.74f, 1.3);
  EXPECT_NE(first, "");
  EXPECT_EQ(after_kerb_at(0.70f, 1.5), first) << "in the same quarter of a second";
}

TEST(Kept, NothingIsWrittenDownWhereNothingIsNear) {
  NearLoss memory{NearLossLimits{}};
  judged(memory, Scene());
  EXPECT_EQ(memory.serialised(), "");
}

TEST(Kept, WhatWasSeenFromSeveralPosesIsOneThingStill) {
  Kept kept{640, 480, 0.0f, {lost_at(600)}, {}};
  auto& spots = kept.things.front().lost;
  spots.assign(6, spots.front());
  for (std::size_t i = 0; i < spots.size(); ++i) spots[i].camera.rows[1][3] = -0.1f * static_cast<float>(i / 2);
  const auto read = kept_in(to_text(kept));
  ASSERT_TRUE(read);
  ASSERT_EQ(read->things.size(), 1u);
  const auto& again = read->things.front().lost;
  ASSERT_EQ(again.size(), spots.size());
  for (std::size_t i = 0; i < spots.size(); ++i) EXPECT_EQ(again[i].camera.rows, spots[i].camera.rows) << i;
}

/// Nothing would lie there.
TEST(Kept, APoseThatIsNoneIsRefused) {
  Kept kept{640, 480, 0.0f, {lost_at(600)}, {}};
  ASSERT_TRUE(kept_in(to_text(kept)));
  auto& [x, y, z] = kept.things.front().lost.front().camera.rows;
  for (const float length : {0.0f, 0.5f}) {
    z[2] = length;
    EXPECT_FALSE(kept_in(to_text(kept))) << length;
  }
  x[2] = 1.0f, z[2] = 0.0f;
  EXPECT_FALSE(kept_in(to_text(kept))) << "to the right of itself";
}

TEST(Kept, WhatMakesNoSenseChangesNothing) {
  const std::string text = written_down();
  std::mt19937 random(7);
  NearLoss memory{NearLossLimits{}};
  for (std::size_t size = 0; size + 1 < text.size(); size += 7)
    EXPECT_FALSE(memory.restore(text.substr(0, size))) << size;
  for (int i = 0; i < 2000; ++i) {
    std::string damaged = text;
    for (int j = 0; j < 3; ++j) damaged[random() % damaged.size()] = static_cast<char>(32 + random() % 95);
    memory.restore(damaged);
    if (i % 100 == 0) judged(memory, Scene());
  }
  EXPECT_FALSE(memory.restore("things-4 nan nan nan nan"));
  EXPECT_FALSE(memory.restore("things-4 160 120 0 1 1e999 0 5"));
}

}  // namespace
}  // namespace safety_control_cloud
