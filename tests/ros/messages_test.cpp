// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/ros/messages.hpp"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <cmath>

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

TEST(Messages, CloudIsBorrowedNotCopied) {
  const sensor_msgs::PointCloud2 cloud = message_of(5);
  const Reading reading = view_of(cloud);
  ASSERT_TRUE(std::holds_alternative<CloudView>(reading));
  EXPECT_EQ(std::get<CloudView>(reading).bytes, cloud.data.data());
  EXPECT_EQ(std::get<CloudView>(reading).size(), std::size_t{5});
  EXPECT_EQ(std::get<CloudView>(reading).point_step, std::size_t{32});
}

TEST(Messages, CloudWithoutFieldsIsUnreadable) {
  EXPECT_TRUE(std::holds_alternative<Unreadable>(view_of(sensor_msgs::PointCloud2())));
}

TEST(Messages, TwistHasTheSpeedForwardAndNothingElse) {
  Decision decision;
  decision.speed = 0.2;
  const geometry_msgs::Twist twist = to_twist(decision);
  EXPECT_EQ(twist.linear.x, 0.2);
  EXPECT_EQ(twist.linear.y, 0.0);
  EXPECT_EQ(twist.linear.z, 0.0);
  EXPECT_EQ(twist.angular.x, 0.0);
  EXPECT_EQ(twist.angular.y, 0.0);
  EXPECT_EQ(twist.angular.z, 0.0);
}

TEST(Messages, DecisionAsItIsMadeSaysStop) { EXPECT_EQ(to_twist(Decision{}).linear.x, 0.0); }

TEST(Messages, StateTellsFreeFromBlind) {
  Decision decision;
  decision.cause = Cause::Seen;
  EXPECT_TRUE(std::isinf(to_state(decision, {}).nearest));
  decision.cause = Cause::Blind;
  EXPECT_TRUE(std::isnan(to_state(decision, {}).nearest));
  EXPECT_TRUE(std::isnan(to_state(decision, {}).nearest_point.z));
}

TEST(Messages, StateNumbersAreTheCores) {
  EXPECT_EQ(SafetyState::DANGER, static_cast<int>(Zone::Danger));
  EXPECT_EQ(SafetyState::WARNING, static_cast<int>(Zone::Warning));
  EXPECT_EQ(SafetyState::SAFE, static_cast<int>(Zone::Safe));
  EXPECT_EQ(SafetyState::SEEN, static_cast<int>(Cause::Seen));
  EXPECT_EQ(SafetyState::NO_CLOUD, static_cast<int>(Cause::NoCloud));
  EXPECT_EQ(SafetyState::SILENT, static_cast<int>(Cause::Silent));
  EXPECT_EQ(SafetyState::UNREADABLE, static_cast<int>(Cause::Unreadable));
  EXPECT_EQ(SafetyState::BLIND, static_cast<int>(Cause::Blind));
}

TEST(Messages, OutputKeepsTheStampToTheNanosecondAndTheFrame) {
  const std_msgs::Header header = message_of(0).header;
  Cloud crop;
  crop.push_back(Point(0.1f, 0.2f, 0.3f));
  const sensor_msgs::PointCloud2 output = to_output(crop, header);
  EXPECT_EQ(output.header.stamp, header.stamp);
  EXPECT_EQ(output.header.frame_id, header.frame_id);
  const sensor_msgs::PointCloud2ConstIterator<float> x(output, "x");
  EXPECT_EQ(x[0], 0.1f);
  EXPECT_EQ(x[1], 0.2f);
  EXPECT_EQ(x[2], 0.3f);
}

}  // namespace
}  // namespace safety_control_cloud
