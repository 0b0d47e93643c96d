// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/kept.hpp"

#include <gtest/gtest.h>

#include <random>

#include "../../../safety_control_cloud/core/look/look.hpp"
#include "../../../safety_control_cloud/core/memory/near_loss.hpp"
#include "../scene.hpp"

namespace safety_control_cloud {
namespace {

std::optional<Loss> judged(NearLoss& memory, const Scene& scene) {
  const View view = scene.view();
  const Outlook outlook;
  return memory.judge(view, look(view, outlook, Crop::Skip, memory.rows_for(view)), outlook, 1.0);
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

TEST(Kept, KerbThatHidTheFloorOutlivesTheProcess) {
  NearLoss memory{NearLossLimits{}}, reborn{NearLossLimits{}};
  for (const float z : {0.74f, 0.70f, 0.62f}) judged(memory, Scene({{z, -0.2f, 0.2f, floor_y - 0.05f, floor_y}}));
  ASSERT_TRUE(reborn.restore(memory.serialised()));
  const auto loss = judged(reborn, Scene({{0.60f, -0.2f, 0.2f, floor_y - 0.05f, floor_y}}));
  ASSERT_TRUE(loss);
  EXPECT_EQ(loss->cause, Cause::LowObstacle);
  EXPECT_TRUE(loss->whole);
}

TEST(Kept, NothingIsWrittenDownWhereNothingIsNear) {
  NearLoss memory{NearLossLimits{}};
  judged(memory, Scene());
  EXPECT_EQ(memory.serialised(), "");
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
  EXPECT_FALSE(memory.restore("things-1 nan nan nan nan"));
  EXPECT_FALSE(memory.restore("things-1 160 120 0 1 1e999 0 5"));
}

}  // namespace
}  // namespace safety_control_cloud
