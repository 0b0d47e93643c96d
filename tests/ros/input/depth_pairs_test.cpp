// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/input/depth_pairs.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace safety_control_cloud {
namespace {

ros::Time at(std::uint32_t stamp) { return {stamp, 1}; }

/// What arrives, by the seconds of its stamp, and the pairs that were made of it.
struct Arrivals {
  std::vector<std::pair<std::uint32_t, std::string>> pairs;  ///< and the bytes of the image
  std::vector<const std::uint8_t*> places;                   ///< of these bytes
  DepthPairs matching{[this](const DepthImage& image, const CameraEvent& camera) {
    EXPECT_EQ(image.header.stamp, camera.getConstMessage()->header.stamp);
    pairs.emplace_back(image.header.stamp.sec, std::string(image.bytes.first, image.bytes.first + image.bytes.size));
    places.push_back(image.bytes.first);
  }};

  /// Lends its bytes for the length of the call, as roscpp does.
  void image(std::uint32_t stamp, const std::string& pixels = "depths") {
    std::vector<std::uint8_t> buffer(pixels.begin(), pixels.end());
    DepthImage image;
    image.header.stamp = at(stamp);
    image.bytes = {buffer.data(), buffer.size()};
    matching.add(image);
    buffer.assign(buffer.size(), 'x');
  }

  void camera(std::uint32_t stamp) {
    const auto info = boost::make_shared<sensor_msgs::CameraInfo>();
    info->header.stamp = at(stamp);
    matching.add(CameraEvent(info, at(0)));
  }

  std::vector<std::uint32_t> stamps() const {
    std::vector<std::uint32_t> all;
    for (const auto& pair : pairs) all.push_back(pair.first);
    return all;
  }
};

using Stamps = std::vector<std::uint32_t>;

TEST(DepthPairs, OfTwoImagesWithOneStampTheLaterIsTaken) {
  Arrivals arrivals;
  arrivals.image(1, "earlier");
  arrivals.image(1, "later");
  arrivals.camera(1);
  ASSERT_EQ(arrivals.pairs.size(), 1u);
  EXPECT_EQ(arrivals.pairs[0].second, "later");
}

TEST(DepthPairs, ImageAfterItsCameraInfoIsPairedAtOnceAndNotCopied) {
  Arrivals arrivals;
  arrivals.camera(1);
  const std::string pixels = "depths";
  DepthImage image;
  image.header.stamp = at(1);
  image.bytes = {reinterpret_cast<const std::uint8_t*>(pixels.data()), pixels.size()};
  arrivals.matching.add(image);
  ASSERT_EQ(arrivals.stamps(), Stamps{1});
  EXPECT_EQ(arrivals.places[0], image.bytes.first);
}

TEST(DepthPairs, ImageBeforeItsCameraInfoIsKeptAsItWas) {
  Arrivals arrivals;
  arrivals.image(1, "first");
  EXPECT_EQ(arrivals.stamps(), Stamps{});
  arrivals.camera(1);
  ASSERT_EQ(arrivals.stamps(), Stamps{1});
  EXPECT_EQ(arrivals.pairs[0].second, "first");
}

TEST(DepthPairs, SeveralImagesWaitEachForItsOwn) {
  Arrivals arrivals;
  for (const std::uint32_t stamp : {1u, 2u, 3u}) arrivals.image(stamp, "image " + std::to_string(stamp));
  for (const std::uint32_t stamp : {1u, 2u, 3u}) arrivals.camera(stamp);
  ASSERT_EQ(arrivals.stamps(), (Stamps{1, 2, 3}));
  for (const auto& [stamp, pixels] : arrivals.pairs) EXPECT_EQ(pixels, "image " + std::to_string(stamp));
}

TEST(DepthPairs, StampsThatDifferByANanosecondAreNoPair) {
  Arrivals arrivals;
  const auto info = boost::make_shared<sensor_msgs::CameraInfo>();
  info->header.stamp = at(1) + ros::Duration(0, 1);
  arrivals.matching.add(CameraEvent(info, at(0)));
  arrivals.image(1);
  EXPECT_EQ(arrivals.stamps(), Stamps{});
}

TEST(DepthPairs, CameraInfoServesOneImage) {
  Arrivals arrivals;
  arrivals.camera(1);
  arrivals.image(1);
  arrivals.image(1);
  EXPECT_EQ(arrivals.stamps(), Stamps{1});
}

TEST(DepthPairs, WhatIsOlderThanAPairWaitsNoLonger) {
  Arrivals arrivals;
  arrivals.image(1);
  arrivals.camera(2);
  arrivals.image(3);
  arrivals.camera(3);
  arrivals.camera(1);
  arrivals.image(2);
  EXPECT_EQ(arrivals.stamps(), Stamps{3});
}

TEST(DepthPairs, OnlyTheLatestFewWait) {
  Arrivals arrivals;
  const auto many = static_cast<std::uint32_t>(DepthPairs::waiting);
  for (std::uint32_t stamp = 0; stamp <= many; ++stamp) arrivals.image(stamp, std::to_string(stamp));
  arrivals.camera(0);
  EXPECT_EQ(arrivals.stamps(), Stamps{});
  arrivals.camera(1);
  ASSERT_EQ(arrivals.stamps(), Stamps{1});
  EXPECT_EQ(arrivals.pairs[0].second, "1");

  for (std::uint32_t stamp = 10; stamp <= 10 + many; ++stamp) arrivals.camera(stamp);
  arrivals.image(10);
  arrivals.image(11);
  EXPECT_EQ(arrivals.stamps(), (Stamps{1, 11}));
}

TEST(DepthPairs, RecordingThatStartsAgainIsPairedAgain) {
  Arrivals arrivals;
  for (const std::uint32_t stamp : {100u, 101u, 102u, 103u, 104u, 105u, 106u}) arrivals.camera(stamp);
  for (const std::uint32_t stamp : {1u, 2u}) {
    arrivals.camera(stamp);
    arrivals.image(stamp);
  }
  EXPECT_EQ(arrivals.stamps(), (Stamps{1, 2}));
}

TEST(DepthPairs, MemoryOfAKeptImageIsUsedAgain) {
  Arrivals arrivals;
  for (std::uint32_t stamp = 1; stamp <= 4; ++stamp) {
    arrivals.image(stamp, "the same length");
    arrivals.camera(stamp);
  }
  EXPECT_EQ(arrivals.places, std::vector<const std::uint8_t*>(4, arrivals.places[0]));
}

TEST(DepthPairs, ImageThatSomebodyOwnsIsKeptWithoutACopy) {
  Arrivals arrivals;
  const auto owner = boost::make_shared<std::string>("owned");
  {
    DepthImage image;
    image.header.stamp = at(1);
    image.bytes = {reinterpret_cast<const std::uint8_t*>(owner->data()), owner->size()};
    image.owner = owner;
    arrivals.matching.add(image);
  }
  EXPECT_EQ(owner.use_count(), 2);
  arrivals.camera(1);
  ASSERT_EQ(arrivals.stamps(), Stamps{1});
  EXPECT_EQ(arrivals.places[0], reinterpret_cast<const std::uint8_t*>(owner->data()));
  EXPECT_EQ(owner.use_count(), 1);
}

}  // namespace
}  // namespace safety_control_cloud
