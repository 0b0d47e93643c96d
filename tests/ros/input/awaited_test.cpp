// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/input/awaited.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

const std::string cloud = "sensor_msgs/PointCloud2", image = "sensor_msgs/Image", topic = "/robot/points";
const std::vector<Wanted> clouds = {{topic, cloud}};

TEST(Awaited, ATopicThatNobodyPublishesIsNamed) {
  EXPECT_EQ(why_nothing_came(clouds, {{"/tf", "tf2_msgs/TFMessage", {"/base"}}}), "nobody publishes /robot/points");
}

TEST(Awaited, ThePlaceWhereSuchAThingIsPublishedIsNamed) {
  EXPECT_EQ(
      why_nothing_came(clouds, {{"/camera/depth/points", cloud, {"/camera"}}}),
      "nobody publishes /robot/points; sensor_msgs/PointCloud2 is published on /camera/depth/points: remap to it, if"
      " that is meant");
}

TEST(Awaited, WhatTheNodeItselfPublishesIsNoInput) {
  const Published crop{"/output", cloud, {"/safety_control_node"}}, camera{"/camera/depth/points", cloud, {"/camera"}};
  EXPECT_EQ(why_nothing_came(clouds, {crop}, "/output"), "nobody publishes /robot/points");
  const std::string with_camera = why_nothing_came(clouds, {crop, camera}, "/output");
  EXPECT_NE(with_camera.find("is published on /camera/depth/points: remap"), std::string::npos) << with_camera;
}

TEST(Awaited, ATypeThatDoesNotFitIsNamedWithItsPublisher) {
  EXPECT_EQ(why_nothing_came(clouds, {{topic, image, {"/camera"}}}),
            "/camera publishes /robot/points as sensor_msgs/Image, not as sensor_msgs/PointCloud2");
}

TEST(Awaited, PublishersThatAreSilentAreCountedAndNamed) {
  EXPECT_EQ(why_nothing_came(clouds, {{topic, cloud, {"/left", "/right"}}}),
            "/robot/points has 2 publishers, /left, /right, and nothing has come from there");
}

TEST(Awaited, OfAnImageAndItsCameraTheOneThatIsMissingIsNamed) {
  EXPECT_EQ(why_nothing_came({{"/depth/image_rect", image}, {"/depth/camera_info", "sensor_msgs/CameraInfo"}},
                             {{"/depth/image_rect", image, {"/camera"}}}),
            "nobody publishes /depth/camera_info");
}

TEST(Awaited, ALongListIsCutShort) {
  std::vector<Published> many;
  for (const char* name : {"/a", "/b", "/c", "/d", "/e"}) many.push_back({name, cloud, {"/camera"}});
  EXPECT_NE(why_nothing_came(clouds, many).find("/a, /b, /c and 2 more"), std::string::npos);
}

}  // namespace
}  // namespace safety_control_cloud
