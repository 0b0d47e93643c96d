// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/doubt/frozen.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "../input/cloud_builder.hpp"

namespace safety_control_cloud {
namespace {

struct Coloured {
  float x, y, z, rgb;
};

/// 20 x 10 points with colours, and 8 bytes after each row.
struct Picture {
  static constexpr std::size_t width = 20, height = 10, row_step = width * sizeof(Coloured) + 8;
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(height * row_step);

  Picture() {
    for (std::size_t i = 0; i < width * height; ++i) {
      const auto value = static_cast<float>(i);
      point(i) = {0.01f * value, 0.02f * value, 2.0f + 0.001f * value, 0.0f};
    }
  }

  Coloured& point(std::size_t i) {
    return *reinterpret_cast<Coloured*>(bytes.data() + i / width * row_step + i % width * sizeof(Coloured));
  }

  CloudView view() const {
    CloudView view;
    view.bytes = bytes.data();
    view.width = width, view.height = height, view.row_step = row_step;
    view.point_step = sizeof(Coloured);
    view.offset = {0, 4, 8};
    return view;
  }
};

TEST(Frozen, ColoursThatChangeDoNotHideAFrozenDepth) {
  Picture picture;
  FrozenWatch watch;
  for (int i = 1; i <= 4; ++i) {
    for (std::size_t k = 0; k < 200; ++k) picture.point(k).rgb = static_cast<float>(i * 1000) + static_cast<float>(k);
    picture.bytes[picture.bytes.size() - 1] = static_cast<std::uint8_t>(i);
    EXPECT_EQ(watch.note(picture.view(), i, 4).has_value(), i == 4) << i;
  }
}

TEST(Frozen, AnyCoordinateThatChangesByOneBitIsLife) {
  for (std::size_t k = 0; k < 200; k += 7) {
    for (float Coloured::*axis : {&Coloured::x, &Coloured::y, &Coloured::z}) {
      Picture picture;
      FrozenWatch watch;
      watch.note(picture.view(), 1.0, 2);
      float& value = picture.point(k).*axis;
      value = std::nextafter(value, 9.0f);
      EXPECT_FALSE(watch.note(picture.view(), 2.0, 2)) << k;
      EXPECT_TRUE(watch.note(picture.view(), 3.0, 2)) << k;
    }
  }
}

TEST(Frozen, PointsThatChangePlacesAreLife) {
  Picture picture;
  FrozenWatch watch;
  watch.note(picture.view(), 1.0, 2);
  std::swap(picture.point(3), picture.point(4));
  EXPECT_FALSE(watch.note(picture.view(), 2.0, 2));
}

TEST(Frozen, CloudThatIsDeliveredTwiceIsNotFrozen) {
  const Picture picture;
  FrozenWatch watch;
  EXPECT_FALSE(watch.note(picture.view(), 1.0, 2));
  EXPECT_FALSE(watch.note(picture.view(), 1.0, 2));
}

TEST(Frozen, WhatComesAgainRepeatsWhateverItsStamp) {
  const Picture picture;
  Picture other;
  other.point(7).z += 0.001f;
  FrozenWatch watch;
  const auto repeats = [&](const Picture& shown, double stamp, std::size_t most) {
    watch.note(shown.view(), stamp, most);
    return watch.repeats();
  };
  EXPECT_FALSE(repeats(picture, 1.0, 10));
  EXPECT_TRUE(repeats(picture, 1.1, 10));
  EXPECT_TRUE(repeats(picture, 1.1, 10));
  EXPECT_FALSE(repeats(other, 1.2, 10));
  EXPECT_FALSE(repeats(other, 1.3, 0)) << "nobody asks";
}

TEST(Frozen, StampThatStandsStillDoesNotHideAFrozenDepth) {
  const Picture picture;
  FrozenWatch watch;
  int believed = 0;
  while (believed < 100 && !watch.note(picture.view(), 1.0, 5)) ++believed;
  EXPECT_EQ(believed, 5) << "the second of its stamp is forgiven";
}

TEST(Frozen, EveryCloudOfAFrozenCameraMayComeTwice) {
  const Picture picture;
  FrozenWatch watch;
  int believed = 0;
  while (believed < 100 && !watch.note(picture.view(), believed / 2, 5)) ++believed;
  EXPECT_EQ(believed, 8);
}

TEST(Frozen, DepthImageIsAllGeometry) {
  std::vector<std::uint16_t> pixels(21 * 4, 1000);
  DepthView view;
  view.bytes = reinterpret_cast<const std::uint8_t*>(pixels.data());
  view.width = 20, view.height = 4, view.row_step = 42;
  view.depth = Depth::Millimetres;
  for (const std::size_t pixel : {0u, 19u, 3u * 21u + 17u, 3u * 21u + 19u}) {
    FrozenWatch watch;
    watch.note(view, 1.0, 2);
    pixels[20] ^= 1;  // what pads a row
    EXPECT_TRUE(watch.note(view, 2.0, 2));
    pixels[pixel] ^= 1;
    EXPECT_FALSE(watch.note(view, 3.0, 2)) << pixel;
  }
}

}  // namespace
}  // namespace safety_control_cloud
