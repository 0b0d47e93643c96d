// SPDX-License-Identifier: BSD-3-Clause
#include "safety_node.hpp"

#include <geometry_msgs/Twist.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>

#include "output/markers.hpp"
#include "output/messages.hpp"
#include "parameters.hpp"

namespace safety_control_cloud {
namespace {

constexpr double log_period = 1.0;      ///< [s] between two lines that say the same
constexpr double markers_period = 0.1;  ///< [s] rviz needs no more
constexpr double shortest_wait = 1e-3;  ///< [s] so that a timer that is due does not spin
constexpr double recording_age = 60.0;  ///< [s] an older stamp is a recording's, not a slow camera's

/// [s] Not ros::Time's own difference, which throws beyond 2^31 s: a stamp may be anything.
double age_of(const std_msgs::Header& cloud) { return ros::Time::now().toSec() - cloud.stamp.toSec(); }

double seconds_since(const ros::SteadyTime& then) { return (ros::SteadyTime::now() - then).toSec(); }

Instant now() { return Instant{ros::SteadyTime::now().toSec(), ros::Time::now().toSec()}; }

/// What to do about a stamp that is far from now, if that is plain.
const char* advice_for(const Decision& decision, const std_msgs::Header& cloud) {
  if (decision.cause != Cause::Stale && decision.cause != Cause::Future) return "";
  if (ros::Time::isSimTime() && ros::Time::now().isZero()) return " (use_sim_time is set and nobody publishes /clock)";
  const bool recording = std::abs(age_of(cloud)) > recording_age;
  return recording ? " (a recording needs: rosparam set use_sim_time true, rosbag play --clock)" : "";
}

}  // namespace

SafetyNode::SafetyNode(ros::NodeHandle handle, ros::NodeHandle private_handle, Delivery delivery)
    : control_(load_settings(private_handle)),
      command_(handle.advertise<geometry_msgs::Twist>("cmd_vel_mux/input/teleop", 1)),
      output_(handle.advertise<sensor_msgs::PointCloud2>("output", 1)),
      state_(private_handle.advertise<SafetyState>("state", 1, true)),
      markers_(private_handle.advertise<visualization_msgs::MarkerArray>("markers", 1, true)),
      reset_(private_handle.advertiseService("reset", &SafetyNode::on_reset, this)),
      reconfigure_(private_handle, control_),
      diagnostics_(handle, private_handle) {
  for (const auto& doubt : doubts_about(control_.settings())) ROS_WARN("%s", doubt.c_str());
  const std::string& target_frame = control_.settings().target_frame;
  if (!target_frame.empty()) camera_place_ = std::make_unique<CameraPlace>(target_frame);
  constexpr bool once = true, not_yet = false;
  quiet_ = handle.createSteadyTimer(ros::WallDuration(1.0), &SafetyNode::on_quiet, this, once, not_yet);
  const OnArrival arrived = [this](const Arrival& arrival) { on_arrival(arrival); };
  if (control_.settings().input == Input::Depth) {
    depths_ = std::make_unique<DepthInput>(handle, private_handle, "camera/depth/image_rect", delivery, arrived);
  } else {
    clouds_ = subscribe_clouds(handle, "camera/depth/points", delivery, arrived);
  }
  publish(control_.without_cloud(now()));
}

SafetyNode::~SafetyNode() { command_.publish(geometry_msgs::Twist()); }

void SafetyNode::on_arrival(const Arrival& arrival) {
  ROS_INFO_ONCE("%s arrived", depths_ ? "Depth image" : "Point cloud");
  last_cloud_ = ros::SteadyTime::now();
  header_ = arrival.header;
  const Decision decision = decide(arrival);
  const double decision_time = seconds_since(last_cloud_), latency = age_of(header_);
  publish(decision);
  if (decision.sight.crop) output_.publish(to_output(*decision.sight.crop, header_));
  diagnostics_.on_cloud(decision, header_, decision_time, latency);
}

/// The one border where an exception becomes a decision: whatever went wrong, the robot stands.
Decision SafetyNode::decide(const Arrival& arrival) {
  Origin origin{arrival.header.stamp.toSec(), OpticalFrame{}, arrival.source};
  try {
    origin.placing = placing_of(arrival.header);
    const Crop crop = output_.getNumSubscribers() > 0 ? Crop::Keep : Crop::Skip;
    return control_.decide(arrival.reading, origin, now(), crop);
  } catch (const std::exception& problem) {
    return control_.decide(Unreadable{problem.what()}, origin, now());
  }
}

Placing SafetyNode::placing_of(const std_msgs::Header& cloud) const {
  return camera_place_ ? camera_place_->at(cloud) : Placing(OpticalFrame{});
}

void SafetyNode::on_quiet(const ros::SteadyTimerEvent&) {
  const Decision decision = control_.without_cloud(now());
  publish(decision);
  diagnostics_.on_quiet(decision);
}

bool SafetyNode::on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& answer) {
  control_.forget_losses();
  answer.success = true;
  answer.message = "near obstacles lost from sight are forgotten";
  return true;
}

void SafetyNode::publish(const Decision& decision) {
  command_.publish(to_twist(decision));
  // As a pointer, it wakes roscpp's thread only if somebody listens.
  state_.publish(boost::make_shared<SafetyState>(to_state(decision, control_.settings(), header_)));
  publish_markers(decision);
  log(decision);
  wake_when_quiet();
}

void SafetyNode::publish_markers(const Decision& decision) {
  const bool has_frame = camera_place_ || !header_.frame_id.empty();  // before the first cloud there may be none
  if (!has_frame || markers_.getNumSubscribers() == 0 || seconds_since(last_markers_) < markers_period) return;
  markers_.publish(to_markers(decision, control_.settings(), header_));
  last_markers_ = ros::SteadyTime::now();
}

void SafetyNode::log(const Decision& decision) {
  const bool changed = decision.zone != logged_.zone || decision.cause != logged_.cause;
  if (!changed && seconds_since(last_log_) < log_period) return;
  if (decision.cause == Cause::Seen) {
    ROS_INFO("%s zone", name_of(decision.zone));
  } else {
    ROS_WARN("%s zone: %s, %s%s", name_of(decision.zone), name_of(decision.cause), decision.reason.c_str(),
             advice_for(decision, header_));
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
