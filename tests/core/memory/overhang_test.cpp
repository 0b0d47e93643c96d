// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/overhang.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../../../safety_control_cloud/core/memory/thing.hpp"

namespace safety_control_cloud {
namespace {

constexpr float none = NAN;

/// Of the uppermost pixel of a thing that is so far away [m] in the lines of one slot, from the upper one down.
float overhang_of(const std::vector<float>& ahead) {
  NearPixels found;
  found.slots = 3;
  for (const float z : ahead) found.ahead.insert(found.ahead.end(), {none, z, none});
  const auto lowest = static_cast<NearPixels::Index>(3 * (ahead.size() - 1) + 1);
  return overhang(found, 1, lowest);
}

TEST(Overhang, WhatRecedesAtOnceAndGoesOnThereIsOverhung) {
  EXPECT_NEAR(overhang_of({0.40f, 0.40f, 0.415f, 0.415f}), 0.015f, 1e-6f);
  EXPECT_GE(overhang_of({0.40f, 0.40f, 0.45f, 0.45f}), clear_overhang);
  EXPECT_NEAR(overhang_of({0.40f, 0.415f, 0.43f, 0.43f, 0.43f}), 0.015f, 1e-6f) << "its first step";
  EXPECT_GE(overhang_of({0.40f, none, none, 0.45f, none, 0.45f}), clear_overhang)
      << "what returns nothing says nothing";
}

TEST(Overhang, WhatIsLowestMayBeNearerAgain) { EXPECT_GE(overhang_of({0.40f, 0.45f, 0.45f, 0.39f}), clear_overhang); }

TEST(Overhang, TheMostCounts) { EXPECT_GE(overhang_of({0.40f, 0.415f, 0.415f, 0.40f, 0.45f, 0.45f}), clear_overhang); }

TEST(Overhang, WhatLeansOrIsNoiseOrComesForwardIsNot) {
  std::vector<float> leaning;
  for (int i = 0; i < 30; ++i) leaning.push_back(0.40f + 0.003f * static_cast<float>(i));
  EXPECT_EQ(overhang_of(leaning), 0.0f);
  EXPECT_EQ(overhang_of({0.40f, 0.409f, 0.409f, 0.40f}), 0.0f);
  EXPECT_EQ(overhang_of({0.40f, 0.45f, 0.40f, 0.45f, 0.40f}), 0.0f) << "in single lines";
  EXPECT_EQ(overhang_of({0.45f, 0.40f, 0.40f, 0.45f, 0.45f}), 0.0f) << "what is before it in the middle overhangs";
  EXPECT_EQ(overhang_of({0.40f}), 0.0f);
}

}  // namespace
}  // namespace safety_control_cloud
