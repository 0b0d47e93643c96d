// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/doubt/turns.hpp"

#include <gtest/gtest.h>

#include <random>

namespace safety_control_cloud {
namespace {

constexpr double timeout = 0.5;

/// Sends pictures 20 ms apart; true if the last of them was doubted.
class Camera {
 public:
  bool sends(Picture picture) {
    now_ += 0.02;
    picture.stamp += now_;
    return watch_.note(picture, now_, timeout).has_value();
  }

 private:
  TurnsWatch watch_;
  double now_ = 10.0;
};

TEST(Turns, TwoCamerasThatShareAConnectionAreToldByTheirFrames) {
  Camera camera;
  bool doubted = false;
  for (int i = 0; i < 16; ++i) doubted = camera.sends({0.0, i % 2 == 0 ? "left" : "right", 0.5, 2.0});
  EXPECT_TRUE(doubted);
}

TEST(Turns, TwoCamerasThatShareAConnectionAreToldByStampsThatRunBackwards) {
  Camera camera;
  bool doubted = false;
  for (int i = 0; i < 16; ++i) doubted = camera.sends({i % 2 == 0 ? 0.0 : -0.1, "camera", 0.5, 2.0});
  EXPECT_TRUE(doubted);
}

TEST(Turns, TwoCamerasThatShareAConnectionAreToldByWhatTheySeeInWhateverOrderTheySend) {
  for (const char* order : {"ABABABABABABABAB", "ABBAABBAABBAABBA", "AABAABAABAABAABA", "BBABABBAABABABBA"}) {
    Camera by_nearest, by_returns;
    bool nearest = false, returns = false;
    for (const char* one = order; *one; ++one) {
      nearest = *one == 'A' ? by_nearest.sends({0.0, "camera", 0.5, std::nullopt, 0.0})
                            : by_nearest.sends({0.0, "camera", 0.5, 0.45, 0.1});
      returns = by_returns.sends({0.0, "camera", *one == 'A' ? 0.5 : 0.7, 2.0});
    }
    EXPECT_TRUE(nearest) << order;
    EXPECT_TRUE(returns) << order;
  }
}

/// An emitter that is on in every second picture, or two exposures in turn.
TEST(Turns, OneThatReturnsNowMoreAndNowLessOfTheSameIsOneCameras) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> chance(0.0f, 1.0f);
  for (const float missing : {0.05f, 0.3f, 0.6f}) {
    for (const float other : {1.0f, 1.5f}) {  // as far as what another camera sees
      Camera camera;
      bool doubted = false;
      for (int i = 0; i < 40; ++i) {
        const bool is_dim = i % 2 != 0;
        Picture picture{0.0, "camera", is_dim ? 0.9 * (1.0 - double{missing}) : 0.9, 2.0};
        for (std::size_t j = 0; j < picture.probes.depths.size(); ++j) {
          const float depth = (is_dim ? other : 1.0f) * (1.5f + 0.03f * static_cast<float>(j));
          if (!is_dim || chance(random) >= missing) picture.probes.depths[j] = depth * (1.0f + 0.01f * chance(random));
        }
        doubted = camera.sends(picture);
      }
      EXPECT_EQ(doubted, other > 1.0f) << missing;
    }
  }
}

TEST(Turns, OneCameraIsBelievedAgainWhenTheOtherHasGone) {
  Camera camera;
  for (int i = 0; i < 16; ++i) camera.sends({0.0, i % 2 == 0 ? "left" : "right", 0.5, 2.0});
  bool doubted = true;
  for (int i = 0; i < 16 + 26; ++i) doubted = camera.sends({0.0, "left", 0.5, 2.0});
  EXPECT_FALSE(doubted);
}

TEST(Turns, FalsePointsThatComeAndGoAreOneCameras) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> distance(0.5, 5.0), chance(0.0, 1.0), noise(-0.005, 0.005);
  Camera camera;
  for (int i = 0; i < 20000; ++i) {
    const bool speckle = chance(random) < 0.5;
    EXPECT_FALSE(
        camera.sends({0.0, "camera", 0.5 + noise(random), speckle ? std::optional(distance(random)) : std::nullopt}))
        << i;
  }
}

/// Of few points some more or less return by chance.
TEST(Turns, ASmallPictureIsOneCameras) {
  std::mt19937 random(4);
  for (const int points : {64, 200, 768, 3072}) {
    for (const double share : {0.02, 0.1, 0.3, 0.8}) {
      std::binomial_distribution<int> some(points, share);
      Camera camera;
      const auto all = static_cast<double>(points);
      for (int i = 0; i < 5000; ++i) {
        const Picture picture{0.0, "camera", some(random) / all, 2.0, some(random) / all, std::size_t(points)};
        ASSERT_FALSE(camera.sends(picture)) << points << " points, " << share << ", " << i;
      }
    }
  }
}

TEST(Turns, PixelThatFlickersIsOneCameras) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  for (const double share : {0.1, 0.3, 0.5, 0.7}) {
    for (const std::optional<double> wall : {std::optional<double>(), std::optional(3.0)}) {
      Camera camera;
      int doubted = 0;
      for (int i = 0; i < 3000; ++i) {
        const bool shown = chance(random) < share;
        doubted += camera.sends({0.0, "camera", 0.5, shown ? std::optional(1.6) : wall, shown ? 5e-5 : 0.0});
      }
      EXPECT_LT(doubted, 60) << share;
    }
  }
}

TEST(Turns, TwoCamerasThatDifferInTheirNearestAloneAreToldWhileTheyTakeTurns) {
  Camera camera;
  bool doubted = false;
  for (int i = 0; i < 16; ++i) doubted = camera.sends({0.0, "camera", 0.5, i % 2 == 0 ? 0.45 : 2.0, 0.1});
  EXPECT_TRUE(doubted);
}

TEST(Turns, WhatMovesBeforeOneCameraIsOneCameras) {
  Camera camera;
  for (int i = 0; i < 500; ++i) {
    const bool person = (i / 15) % 2 == 0;
    EXPECT_FALSE(camera.sends({0.0, "camera", person ? 0.8 : 0.5, person ? 0.6 : 2.0 - 0.004 * i})) << i;
  }
}

}  // namespace
}  // namespace safety_control_cloud
