// SPDX-License-Identifier: BSD-3-Clause
#include "odometry_input.hpp"

#include <ros/transport_hints.h>

#include <cstdint>
#include <utility>

#include "../graph/named_in.hpp"
#include "poses.hpp"

namespace safety_control_cloud {
namespace {

constexpr double patience = 5.0;             // [s]
constexpr std::uint32_t most_waiting = 100;  // a second or two, so that a thread that is kept waiting hears all of it

}  // namespace

OdometryInput::OdometryInput(ros::NodeHandle& handle, GuardControl& control, const tf2_ros::Buffer& buffer,
                             std::function<void()> beat, std::function<void(const std::string&)> warn)
    : control_(control), buffer_(buffer), beat_(std::move(beat)), warn_(std::move(warn)) {
  const Settings& settings = control_.settings();
  if (!settings.odom_frame.empty()) {
    transforms_.emplace(settings.odom_frame, settings.base_frame);
    return;
  }
  subscriber_ = handle.subscribe<nav_msgs::Odometry>(
      named_in(handle, "odom"), most_waiting,
      boost::function<void(const ros::MessageEvent<nav_msgs::Odometry const>&)>(
          [this](const ros::MessageEvent<nav_msgs::Odometry const>& event) { on_message(event); }),
      nullptr, ros::TransportHints().tcpNoDelay());
}

void OdometryInput::ask() {
  const auto told = transforms_ ? transforms_->next(buffer_) : std::nullopt;
  if (told) control_.note_pose(told->stamp, told->pose);
  warn_of_frame_that_nobody_knows();
}

/// TF may take a while to come.
void OdometryInput::warn_of_frame_that_nobody_knows() {
  const bool knows = !transforms_ || transforms_->why_nothing().empty();
  if (warned_of_frame_ || knows || (ros::SteadyTime::now() - began_).toSec() < patience) return;
  warn_("odom_frame " + control_.settings().odom_frame + ": TF does not tell where the robot is in it: no odometry; " +
        transforms_->why_nothing());
  warned_of_frame_ = true;
}

void OdometryInput::on_message(const ros::MessageEvent<nav_msgs::Odometry const>& event) {
  beat_();
  const nav_msgs::Odometry& odometry = *event.getConstMessage();
  note_publisher(event.getPublisherName());
  const auto base = base_in(odometry.child_frame_id);
  if (!base) return;
  const auto& twist = odometry.twist.twist;
  control_.note_odometry(odometry.header.stamp.toSec(), pose_of(odometry.pose.pose),
                         {twist.linear.x, twist.linear.y, twist.angular.z}, *base);
}

/// Where base_frame is in it. Some drivers leave the name empty.
std::optional<Pose2> OdometryInput::base_in(const std::string& child_frame) {
  const std::string frame = child_frame.substr(child_frame.compare(0, 1, "/") == 0 ? 1 : 0);  // as tf had it, before tf2
  const std::string& base = control_.settings().base_frame;
  if (frame == base || frame.empty()) return Pose2{};
  try {
    return pose_of(buffer_.lookupTransform(frame, base, ros::Time(0)).transform);
  } catch (const tf2::TransformException& problem) {
    if (!warned_of_frame_ && (ros::SteadyTime::now() - began_).toSec() > patience) {
      warn_("odometry is of " + frame + ", and TF does not tell where " + base + " is in it: no odometry; " +
            problem.what());
      warned_of_frame_ = true;
    }
    return std::nullopt;
  }
}

/// One that was started again under another name is not two.
void OdometryInput::note_publisher(const std::string& name) {
  if (name == latest_) return;
  if (name == before_ && !warned_of_two_) {
    warn_("odometry comes from " + name + " and from " + latest_ + " in turn; where the robot went, only one may tell");
    warned_of_two_ = true;
  }
  before_ = std::exchange(latest_, name);
}

}  // namespace safety_control_cloud
