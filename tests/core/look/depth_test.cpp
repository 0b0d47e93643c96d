// SPDX-License-Identifier: BSD-3-Clause
// A depth image shows what the cloud that depth_image_proc makes of it shows, to the bit, on 10,000 random images, with
// every instruction set of this machine. CMake builds this test twice, as it does scan_test.
#include "../../../safety_control_cloud/core/input/depth.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "../../../safety_control_cloud/core/input/point_reader.hpp"
#include "../../../safety_control_cloud/core/look/kernel/scan.hpp"
#include "../../../safety_control_cloud/core/look/passthrough.hpp"
#include "../../../safety_control_cloud/core/safety_control.hpp"
#include "random_depth.hpp"
#include "same_sight.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::uint64_t images = 10000;

class DepthImage : public InstructionSet {};

INSTANTIATE_TEST_SUITE_P(With, DepthImage, testing::ValuesIn(instruction_sets()),
                         [](const auto& info) { return info.param; });

TEST_P(DepthImage, ShowsWhatPclSeesInItsCloud) {
  for (std::uint64_t seed = 0; seed < images; ++seed) {
    const RandomDepth image(seed);
    const Sight expected = seen_by(passthrough, image.cloud(), image);
    for (const auto method : {look, passthrough}) {
      const Sight seen = seen_by(method, image.view, image);
      ASSERT_TRUE(same(seen, expected)) << "seed " << seed << ": " << words(seen) << "; PCL: " << words(expected);
    }
  }
}

TEST_P(DepthImage, AskingForTheCropDoesNotChangeWhatIsSeen) {
  for (std::uint64_t seed = 0; seed < images / 10; ++seed) {
    const RandomDepth image(seed);
    Sight with = look(image.view, image.corridor, Crop::Keep);
    with.crop.reset();
    ASSERT_TRUE(same(with, look(image.view, image.corridor))) << "seed " << seed;
  }
}

/// 64 x 48 pixels, 60 degrees wide.
struct Camera {
  std::vector<float> pixels;
  std::vector<Xyz> points{};
  double across = 31.5, down = 23.5;  ///< [px] where the optical axis meets it

  explicit Camera(float depth) : pixels(64 * 48, depth) {}

  DepthView view() const {
    DepthView view;
    view.bytes = reinterpret_cast<const std::uint8_t*>(pixels.data());
    view.width = 64, view.height = 48, view.row_step = 64 * sizeof(float);
    view.camera = {55.4, 55.4, across, down};
    return view;
  }

  /// The same as a cloud; valid until the next one.
  CloudView cloud() {
    points.clear();
    for_each_point(view(), [this](float x, float y, float z) { points.push_back({x, y, z}); });
    CloudView cloud = view_of(points);
    cloud.width = 64, cloud.height = 48, cloud.row_step = 64 * sizeof(Xyz);
    return cloud;
  }
};

Decision decide(SafetyControl& control, const Camera& camera, double now) {
  return control.decide(camera.view(), Origin{now}, Instant{now, now});
}

TEST(DepthImages, NearestPixelDecidesTheZone) {
  SafetyControl control{Settings{}};
  Camera camera(2.0f);
  EXPECT_EQ(decide(control, camera, 1.0).zone, Zone::Safe);
  camera.pixels[24 * 64 + 32] = 0.7f;
  const Decision decision = decide(control, camera, 1.05);
  EXPECT_EQ(decision.zone, Zone::Warning);
  EXPECT_EQ(decision.nearest->point.z, 0.7f);
}

/// REP 117, in either byte order and whichever way it is looked at.
TEST(DepthImages, PixelOfMinusInfinityIsTooClose) {
  for (const auto method : {Method::OnePass, Method::Pcl}) {
    Settings settings;
    settings.method = method;
    SafetyControl control(settings);
    Camera camera(2.0f);
    EXPECT_EQ(decide(control, camera, 1.0).speed, 0.2);
    camera.pixels[24 * 64 + 32] = -inf;
    const Decision decision = decide(control, camera, 1.05);
    EXPECT_EQ(decision.cause, Cause::Seen);
    EXPECT_EQ(decision.speed, 0.0);
    EXPECT_EQ(decision.nearest->distance(), 0.0);
    EXPECT_EQ(decision.sight.too_close, 1u);
    EXPECT_EQ(decision.sight.returns, 64u * 48u - 1u);
  }
}

TEST(DepthImages, PixelOfMinusInfinityIsNothingWhereTheParameterSaysSo) {
  Settings settings;
  settings.depth_minus_inf = MinusInf::Nothing;
  SafetyControl control(settings);
  Camera camera(2.0f);
  camera.pixels[24 * 64 + 32] = -inf;
  EXPECT_EQ(decide(control, camera, 1.0).speed, 0.2);
}

/// As a cloud whose points at -Inf keep no x and y.
TEST_P(DepthImage, MinusInfinityIsTooCloseAndAllElseIsAsEver) {
  std::size_t met = 0;
  for (std::uint64_t seed = 0; seed < images / 10; ++seed) {
    RandomDepth image(seed);
    image.view.minus_inf = MinusInf::TooClose;
    std::vector<Xyz> points = image.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!image.is_minus_inf(i)) continue;
      points[i] = {nan, nan, -inf};
      ++met;
    }
    CloudView cloud = image.cloud();
    cloud.bytes = reinterpret_cast<const std::uint8_t*>(points.data());
    const Sight expected = seen_by(passthrough, cloud, image);
    for (const auto method : {look, passthrough}) {
      const Sight seen = seen_by(method, image.view, image);
      ASSERT_TRUE(same(seen, expected)) << "seed " << seed << ": " << words(seen) << "; PCL: " << words(expected);
    }
  }
  EXPECT_GT(met, 1000u);
}

TEST(DepthImages, BlankImageIsBlind) {
  SafetyControl control{Settings{}};
  EXPECT_EQ(decide(control, Camera(nan), 1.0).cause, Cause::Blind);
  EXPECT_EQ(decide(control, Camera(0.0f), 1.05).cause, Cause::Blind);
  EXPECT_EQ(control.decide(DepthView{}, Origin{1.1}, Instant{1.1, 1.1}).cause, Cause::Blind) << "no pixels";
}

TEST(DepthImages, ObstacleThatStopsReturningIsKept) {
  SafetyControl control{Settings{}};
  Camera camera(2.0f);
  for (std::size_t row = 10; row < 40; ++row) std::fill_n(camera.pixels.begin() + row * 64 + 25, 12, 0.45f);
  EXPECT_EQ(decide(control, camera, 1.0).cause, Cause::Seen);
  for (float& pixel : camera.pixels) pixel = pixel < 1.0f ? nan : pixel;
  EXPECT_EQ(decide(control, camera, 1.05).cause, Cause::NearLoss);
  EXPECT_EQ(decide(control, Camera(2.0f), 1.1).cause, Cause::Seen) << "seen behind it";
}

TEST(DepthImages, SameImageAgainAndAgainIsFrozen) {
  Settings settings;
  settings.frozen_clouds = 3;
  SafetyControl control(settings);
  Camera camera(2.0f);
  decide(control, camera, 1.0);
  decide(control, camera, 1.05);
  EXPECT_EQ(decide(control, camera, 1.1).cause, Cause::Frozen);
  camera.pixels.back() = 2.001f;
  EXPECT_EQ(decide(control, camera, 1.15).cause, Cause::Seen);
}

void expect_same(const Decision& seen, const Decision& expected, std::uint64_t seed) {
  ASSERT_EQ(name_of(seen.cause), name_of(expected.cause)) << "seed " << seed;
  ASSERT_EQ(seen.zone, expected.zone) << "seed " << seed;
  ASSERT_EQ(seen.reason, expected.reason) << "seed " << seed;
  ASSERT_TRUE(same(seen.sight, expected.sight)) << "seed " << seed;
}

/// Of a few rows, or of another camera in each cloud, the image alone tells which way it looks, and so the memory of
/// pictures is left out.
TEST(DepthImages, SequenceIsDecidedAsItsCloudsAre) {
  Settings settings;
  settings.min_valid_ratio = 0.0;
  settings.depth_minus_inf = MinusInf::Nothing;
  Settings forgetful = settings;
  forgetful.near_loss.distance = 0.0;
  for (std::uint64_t start = 0; start < images; start += 20) {
    SafetyControl by_depth(settings), by_cloud(settings), depth_alone(forgetful), cloud_alone(forgetful);
    for (std::uint64_t seed = start; seed < start + 20; ++seed) {
      const RandomDepth image(seed);
      const Origin origin{0.05 * static_cast<double>(seed)};
      const Instant now{origin.stamp, origin.stamp};
      expect_same(depth_alone.decide(image.view, origin, now), cloud_alone.decide(image.cloud(), origin, now), seed);
      if (image.view.width >= 2 && image.view.height >= 2) continue;
      expect_same(by_depth.decide(image.view, origin, now), by_cloud.decide(image.cloud(), origin, now), seed);
      if (HasFatalFailure()) return;
    }
  }
}

/// Things near and far, and holes, come and go.
TEST(DepthImages, WhatIsRememberedIsWhatIsRememberedOfItsClouds) {
  int lost = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    const auto up_to = [&](std::size_t size) { return random() % size; };
    SafetyControl by_depth{Settings{}}, by_cloud{Settings{}};
    // Between pixels, since half of one is rounded as it comes.
    const double across = 10.3 + static_cast<double>(up_to(44)), down = 10.3 + static_cast<double>(up_to(28));
    for (int i = 0; i < 20; ++i) {
      Camera camera(2.0f);
      camera.across = across, camera.down = down;
      for (int things = 0; things < 3; ++things) {
        const float depth = std::array{0.45f, 0.6f, nan, nan, 1.2f}[up_to(5)];
        const std::size_t left = up_to(52), top = up_to(36), columns = 2 + up_to(10), rows = 2 + up_to(10);
        for (std::size_t row = top; row < top + rows; ++row)
          std::fill_n(camera.pixels.begin() + static_cast<std::ptrdiff_t>(row * 64 + left), columns, depth);
      }
      const Origin origin{1.0 + 0.05 * i};
      const Instant now{origin.stamp, origin.stamp};
      const Decision seen = by_depth.decide(camera.view(), origin, now);
      expect_same(seen, by_cloud.decide(camera.cloud(), origin, now), seed);
      if (HasFatalFailure()) return;
      lost += seen.cause == Cause::NearLoss;
    }
  }
  EXPECT_GT(lost, 100);
}

}  // namespace
}  // namespace safety_control_cloud
