// SPDX-License-Identifier: BSD-3-Clause
#include "odometry_input.hpp"

#include <ros/transport_hints.h>

#include <cmath>
#include <cstdint>
#include <utility>

#include "../../core/input/angle.hpp"
#include "../graph/named_in.hpp"
#include "poses.hpp"

namespace safety_control_cloud {
namespace {

constexpr double patience = 5.0;             // [s]
constexpr double most_moved = 0.03;          // [m] and [rad], of what is fixed on the robot
constexpr std::uint32_t most_waiting = 100;  // a second or two, so that a thread that is kept waiting hears all of it

/// As tf had it, before tf2.
std::string without_slash(const std::string& frame) { return frame.substr(frame.compare(0, 1, "/") == 0 ? 1 : 0); }

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
  const auto base = base_in(odometry);
  if (!base) return;
  const auto& twist = odometry.twist.twist;
  control_.note_odometry(odometry.header.stamp.toSec(), pose_of(odometry.pose.pose),
                         {twist.linear.x, twist.linear.y, twist.angular.z}, *base);
}

/// Where base_frame is in it. Some drivers leave the name empty.
std::optional<Pose2> OdometryInput::base_in(const nav_msgs::Odometry& odometry) {
  const std::string frame = without_slash(odometry.child_frame_id);
  const std::string& base = control_.settings().base_frame;
  if (frame == base || frame.empty()) return Pose2{};
  const auto is_none_for = [&](const std::string& reason) {
    if (!warned_of_frame_) warn_("odometry is of " + frame + ", " + reason);
    warned_of_frame_ = true;
    return std::nullopt;
  };
  if (frame == without_slash(odometry.header.frame_id)) return is_none_for("the frame in which it tells: no odometry");
  try {
    const Pose2 place = pose_of(buffer_.lookupTransform(frame, base, ros::Time(0)).transform);
    if (!fixed_) fixed_ = place;
    const Pose2 moved = between(*fixed_, place);
    if (length_of(moved.place) + std::abs(wrapped(moved.heading)) > most_moved)
      return is_none_for("on which " + base + " moves: no odometry");
    return place;
  } catch (const tf2::TransformException& problem) {
    if ((ros::SteadyTime::now() - began_).toSec() <= patience) return std::nullopt;
    return is_none_for("and TF does not tell where " + base + " is in it: no odometry; " + problem.what());
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
