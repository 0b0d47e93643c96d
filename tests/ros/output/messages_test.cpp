// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/output/messages.hpp"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <cmath>

namespace safety_control_cloud {
namespace {

std_msgs::Header header() {
  std_msgs::Header header;
  header.frame_id = "camera_depth_optical_frame";
  header.stamp = ros::Time(12, 345678901);
  return header;
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
  EXPECT_TRUE(std::isinf(to_state(decision, Settings{}, {}).nearest));
  decision.cause = Cause::Blind;
  EXPECT_TRUE(std::isnan(to_state(decision, Settings{}, {}).nearest));
  EXPECT_TRUE(std::isnan(to_state(decision, Settings{}, {}).nearest_point.z));
}

TEST(Messages, StateNumbersAreTheCores) {
  EXPECT_EQ(SafetyState::DANGER, static_cast<int>(Zone::Danger));
  EXPECT_EQ(SafetyState::WARNING, static_cast<int>(Zone::Warning));
  EXPECT_EQ(SafetyState::SAFE, static_cast<int>(Zone::Safe));
}

TEST(Messages, EveryCauseBearsTheSameNumberAndNameInTheMessage) {
  const std::vector<std::pair<int, const char*>> causes = {{SafetyState::SEEN, "SEEN"},
                                                           {SafetyState::NO_CLOUD, "NO_CLOUD"},
                                                           {SafetyState::SILENT, "SILENT"},
                                                           {SafetyState::UNREADABLE, "UNREADABLE"},
                                                           {SafetyState::BLIND, "BLIND"},
                                                           {SafetyState::STALE, "STALE"},
                                                           {SafetyState::FUTURE, "FUTURE"},
                                                           {SafetyState::CLOCK_JUMP, "CLOCK_JUMP"},
                                                           {SafetyState::NEAR_LOSS, "NEAR_LOSS"},
                                                           {SafetyState::FROZEN, "FROZEN"},
                                                           {SafetyState::NO_TRANSFORM, "NO_TRANSFORM"},
                                                           {SafetyState::TWO_SOURCES, "TWO_SOURCES"},
                                                           {SafetyState::LOW_OBSTACLE, "LOW_OBSTACLE"},
                                                           {SafetyState::TWO_COMMANDERS, "TWO_COMMANDERS"},
                                                           {SafetyState::WRONG_VIEW, "WRONG_VIEW"},
                                                           {SafetyState::NO_TIME, "NO_TIME"},
                                                           {SafetyState::NO_COMMAND, "NO_COMMAND"},
                                                           {SafetyState::BAD_COMMAND, "BAD_COMMAND"},
                                                           {SafetyState::NO_ODOMETRY, "NO_ODOMETRY"},
                                                           {SafetyState::BUMPER, "BUMPER"},
                                                           {SafetyState::CLIFF, "CLIFF"}};
  for (const auto& [number, name] : causes) EXPECT_STREQ(name_of(static_cast<Cause>(number)), name);
  EXPECT_STREQ(name_of(static_cast<Cause>(causes.back().first + 1)), "UNKNOWN") << "a cause is missing in this table";
}

TEST(Messages, NearestPointStandsInTheTargetFrameIfThereIsOne) {
  Settings settings;
  settings.target_frame = "base_footprint";
  Decision decision;
  decision.cause = Cause::Seen;
  decision.nearest = Obstacle{Point(0.1f, -0.3f, 0.8f)};  // right, down, forward
  const SafetyState state = to_state(decision, settings, header());
  EXPECT_EQ(state.nearest_frame, "base_footprint");
  EXPECT_FLOAT_EQ(static_cast<float>(state.nearest_point.x), 0.8f) << "forward";
  EXPECT_FLOAT_EQ(static_cast<float>(state.nearest_point.y), -0.1f) << "left";
  EXPECT_FLOAT_EQ(static_cast<float>(state.nearest_point.z), 0.3f) << "up";
}

TEST(Messages, OutputKeepsTheStampToTheNanosecondAndTheFrame) {
  Cloud crop;
  crop.push_back(Point(0.1f, 0.2f, 0.3f));
  const sensor_msgs::PointCloud2 output = to_output(crop, header());
  EXPECT_EQ(output.header.stamp, header().stamp);
  EXPECT_EQ(output.header.frame_id, header().frame_id);
  const sensor_msgs::PointCloud2ConstIterator<float> x(output, "x");
  EXPECT_EQ(x[0], 0.1f);
  EXPECT_EQ(x[1], 0.2f);
  EXPECT_EQ(x[2], 0.3f);
}

}  // namespace
}  // namespace safety_control_cloud
