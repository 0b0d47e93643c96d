// SPDX-License-Identifier: BSD-3-Clause
#include "safety_node.hpp"

#include <geometry_msgs/Twist.h>

#include <algorithm>

#include "messages.hpp"
#include "parameters.hpp"

namespace safety_control_cloud {
namespace {

constexpr double log_period = 1.0;      ///< [s] between two lines that say the same
constexpr double shortest_wait = 1e-3;  ///< [s] so that a timer that is due does not spin

double seconds_since(const ros::SteadyTime& then) { return (ros::SteadyTime::now() - then).toSec(); }

}  // namespace

SafetyNode::SafetyNode(ros::NodeHandle handle, ros::NodeHandle private_handle)
    : control_(load_settings(private_handle)),
      command_(handle.advertise<geometry_msgs::Twist>("cmd_vel_mux/input/teleop", 1)),
      output_(handle.advertise<sensor_msgs::PointCloud2>("output", 1)),
      state_(private_handle.advertise<SafetyState>("state", 1, true)) {
  constexpr bool once = true, not_yet = false;
  quiet_ = handle.createSteadyTimer(ros::WallDuration(1.0), &SafetyNode::on_quiet, this, once, not_yet);
  const auto hints = ros::TransportHints().tcpNoDelay();
  clouds_ = handle.subscribe("camera/depth/points", 1, &SafetyNode::on_cloud, this, hints);
  publish(control_.without_cloud(ros::SteadyTime::now().toSec()));
}

SafetyNode::~SafetyNode() { command_.publish(geometry_msgs::Twist()); }

void SafetyNode::on_cloud(const sensor_msgs::PointCloud2& cloud) {
  ROS_INFO_ONCE("Point cloud arrived");
  last_cloud_ = ros::SteadyTime::now();
  header_ = cloud.header;
  const Decision decision = decide(cloud);
  publish(decision);
  if (decision.sight.crop) output_.publish(to_output(*decision.sight.crop, cloud.header));
}

/// The one border where an exception becomes a decision: whatever went wrong, the robot stands.
Decision SafetyNode::decide(const sensor_msgs::PointCloud2& cloud) {
  const double now = ros::SteadyTime::now().toSec();
  try {
    return control_.decide(view_of(cloud), now, output_.getNumSubscribers() > 0 ? Crop::Keep : Crop::Skip);
  } catch (const std::exception& problem) {
    return control_.decide(Unreadable{problem.what()}, now);
  }
}

void SafetyNode::on_quiet(const ros::SteadyTimerEvent&) {
  publish(control_.without_cloud(ros::SteadyTime::now().toSec()));
}

void SafetyNode::publish(const Decision& decision) {
  command_.publish(to_twist(decision));
  state_.publish(to_state(decision, header_));
  log(decision);
  wake_when_quiet();
}

void SafetyNode::log(const Decision& decision) {
  const bool changed = decision.zone != logged_.zone || decision.cause != logged_.cause;
  if (!changed && seconds_since(last_log_) < log_period) return;
  if (decision.cause == Cause::Seen) {
    ROS_INFO("%s zone", name_of(decision.zone));
  } else {
    ROS_WARN("%s zone: %s, %s", name_of(decision.zone), name_of(decision.cause), decision.reason.c_str());
  }
  logged_ = decision;
  last_log_ = ros::SteadyTime::now();
}

/// The next command is due after a period without one, or the moment the camera counts as silent if that is sooner.
void SafetyNode::wake_when_quiet() {
  double wait = 1.0 / control_.settings().publish_rate;
  const double until_silent = control_.settings().source_timeout - seconds_since(last_cloud_);
  if (until_silent > 0.0) wait = std::min(wait, until_silent + shortest_wait);
  quiet_.stop();
  quiet_.setPeriod(ros::WallDuration(std::max(wait, shortest_wait)));
  quiet_.start();
}

}  // namespace safety_control_cloud
