// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/input/cloud_message.hpp"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

namespace safety_control_cloud {
namespace {

sensor_msgs::PointCloud2 message_of(std::size_t points) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = "camera_depth_optical_frame";
  cloud.header.stamp = ros::Time(12, 345678901);
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(2, "xyz", "rgb");
  modifier.resize(points);
  return cloud;
}

TEST(CloudMessage, CloudIsBorrowedNotCopied) {
  const sensor_msgs::PointCloud2 cloud = message_of(5);
  const Reading reading = view_of(cloud);
  ASSERT_TRUE(std::holds_alternative<CloudView>(reading));
  EXPECT_EQ(std::get<CloudView>(reading).bytes, cloud.data.data());
  EXPECT_EQ(std::get<CloudView>(reading).size(), std::size_t{5});
  EXPECT_EQ(std::get<CloudView>(reading).point_step, std::size_t{32});
}

TEST(CloudMessage, CloudWithoutFieldsIsUnreadable) {
  EXPECT_TRUE(std::holds_alternative<Unreadable>(view_of(sensor_msgs::PointCloud2())));
}

}  // namespace
}  // namespace safety_control_cloud
