// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/optics.hpp"

#include <gtest/gtest.h>

#include <random>

#include "lens.hpp"

namespace safety_control_cloud {
namespace {

const std::vector<Board> wall = {{2.0f, -9.0f, 9.0f, -9.0f, floor_y}};

/// What the memory takes the rays for; NaN where it does not know.
struct Taken {
  double across, down, focal;
};

class Watching {
 public:
  Taken looks(const Lens& lens, const std::vector<Xyz>& points) {
    const View view = lens.view_of_rows(points);
    const RayLines& lines = optics_.look_at(view, Pixels(view, 0.0f));
    if (!lines.across || !lines.down) return {nan, nan, nan};
    return {lines.across->pixel(0.0), lines.down->pixel(0.0), 1.0 / lines.across->slope};
  }
  Taken looks(const Lens& lens) { return looks(lens, lens.points(wall)); }

 private:
  Optics optics_;
};

void expect_those_of(const Lens& lens, const Taken& taken) {
  EXPECT_NEAR(taken.across, lens.across, 0.05);
  EXPECT_NEAR(taken.down, lens.down, 0.05);
  EXPECT_NEAR(taken.focal / lens.focal, 1.0, 1e-3);
}

TEST(Optics, AnotherPartOfThePictureOrAnotherLensIsNoticedAtOnce) {
  const Lens whole;
  Watching camera;
  for (const Lens& lens :
       {whole.part(20, 10, 120, 100), whole.part(21, 10, 120, 100), whole.part(21, 11, 120, 100),
        whole.part(40, 10, 120, 100), whole, Lens::of(61.0), Lens::of(86.0), Lens::of(42.0), whole.scaled(0.5)})
    expect_those_of(lens, camera.looks(lens));
}

TEST(Optics, ASlowZoomIsNoticed) {
  Watching camera;
  for (double degrees = 60.0; degrees < 70.0; degrees += 0.1) {
    const Lens lens = Lens::of(degrees);
    EXPECT_NEAR(camera.looks(lens).focal / lens.focal, 1.0, 0.02) << degrees;
  }
}

TEST(Optics, WhatReturnsTooLittleChangesNothing) {
  const Lens lens;
  Watching camera;
  expect_those_of(lens, camera.looks(lens));
  std::vector<Xyz> points(lens.width * lens.height, {nan, nan, nan});
  expect_those_of(lens, camera.looks(lens, points));
  points[0] = {0.0f, 0.0f, 1.0f};
  expect_those_of(lens, camera.looks(lens, points));
}

TEST(Optics, RaysAreNotThoseOfAnotherPictureWhileTooLittleReturnsToTell) {
  const Lens lens, half = lens.scaled(0.5);
  Watching camera;
  camera.looks(lens);
  EXPECT_TRUE(std::isnan(camera.looks(half, std::vector<Xyz>(half.width * half.height, {nan, nan, nan})).across));
  expect_those_of(half, camera.looks(half));
}

TEST(Optics, NoiseAndPixelsSetByHandAreNoOtherLens) {
  const Lens lens;
  Watching camera;
  const Taken first = camera.looks(lens);
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0.0f, 0.004f);
  std::bernoulli_distribution odd(0.2);
  for (int i = 0; i < 50; ++i) {
    auto points = lens.points(wall);
    for (Xyz& point : points) {
      point = odd(random) ? Xyz{0.0f, 0.0f, 1.0f} : Xyz{point.x + noise(random), point.y + noise(random), point.z};
    }
    EXPECT_EQ(camera.looks(lens, points).across, first.across) << i;
  }
}

TEST(Optics, ADepthImageSaysItself) {
  Optics optics;
  for (const Lens& lens : {Lens{}, Lens{}.part(20, 0, 140, 120), Lens{}.part(0, 0, 140, 120)}) {
    const std::vector<float> depths(lens.width * lens.height, nan);
    const View view = lens.view_of_depths(depths);
    EXPECT_NEAR(optics.look_at(view, Pixels(view, 0.0f)).across->pixel(0.0), lens.across, 1e-9);
  }
}

}  // namespace
}  // namespace safety_control_cloud
