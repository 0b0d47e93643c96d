// SPDX-License-Identifier: BSD-3-Clause
#include "safety_node.hpp"

#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <utility>

#include "command/leaving.hpp"
#include "graph/named_in.hpp"
#include "output/messages.hpp"
#include "time/moments.hpp"

namespace safety_control_cloud {
SafetyNode::SafetyNode(ros::NodeHandle handle, ros::NodeHandle private_handle, Delivery delivery,
                       const Settings& settings)
    : control_(settings),
      camera_(sensors_of(settings).front(), handle, private_handle, handle.resolveName(named_in(handle, "output"))),
      commands_(handle, named_in(handle, "cmd_vel_mux/input/teleop"), [this] { on_quiet(); }),
      output_(handle.advertise<sensor_msgs::PointCloud2>(named_in(handle, "output"), 1)),
      reports_(private_handle, log_),
      lost_things_(private_handle, LostThings::of(control_, reports_), log_.warner(),
                   [this] { return may_have_waited(now()); }),
      quiet_(*handle.getCallbackQueue(), [this] { on_quiet(); }),
      reconfigure_(
          private_handle, settings, [this](const Settings& changed) { control_.adopt(changed); }, log_),
      diagnostics_(handle, private_handle, log_.warner()) {
  const std::string& target_frame = control_.settings().target_frame;
  if (!target_frame.empty()) camera_place_ = std::make_unique<CameraPlace>(target_frame, log_.warner());
  on_quiet();
  camera_.open(
      handle, private_handle, delivery, [this](const Arrival& arrival) { on_arrival(arrival); }, log_.informer(),
      log_.warner());
}

SafetyNode::~SafetyNode() {
  commands_.end();
  let_it_leave();
}

void SafetyNode::on_arrival(const Arrival& arrival) {
  const Instant came = now();
  gap_.beat(came, control_.settings());
  const double silence = came.steady - last_cloud_.value_or(came.steady);
  const bool silence_was_said = said_ == Cause::Silent;
  if (silence > control_.settings().source_timeout && !silence_was_said) publish(control_.without_cloud(came), came);
  last_cloud_ = came.steady;
  header_ = arrival.header;
  const Decision decision = decide(arrival, came);
  const double decision_time = seconds_since(came), latency = age_of(header_);
  publish(decision, came);
  if (decision.sight.crop) output_.publish(to_output(*decision.sight.crop, header_));
  diagnostics_.on_cloud(decision, header_, decision_time, latency);
}

/// The one border where an exception becomes a decision: whatever went wrong, the robot stands.
Decision SafetyNode::decide(const Arrival& arrival, const Instant& came) {
  Origin origin{arrival.header.stamp.toSec(), OpticalFrame{}, arrival.source, arrival.header.frame_id};
  control_.note_outside(doubt_about(arrival.header, came));
  try {
    origin.placing = placing_of(arrival.header);
    const Crop crop = output_.getNumSubscribers() > 0 ? Crop::Keep : Crop::Skip;
    return control_.decide(arrival.reading, origin, came, crop);
  } catch (const std::exception& problem) {
    return control_.decide(Unreadable{problem.what()}, origin, came);
  }
}

Placing SafetyNode::placing_of(const std_msgs::Header& cloud) const {
  return camera_place_ ? camera_place_->at(cloud) : Placing(OpticalFrame{});
}

/// What somebody asks, while the process stood still.
bool SafetyNode::may_have_waited(const Instant& came) {
  gap_.beat(came, control_.settings());
  return gap_.has_gone_on_within(control_.settings().command_timeout, came);
}

void SafetyNode::on_quiet() {
  const Instant woken = now();
  gap_.beat(woken, control_.settings());
  control_.note_outside(doubt_without_cloud());
  const Decision decision = control_.without_cloud(woken);
  publish(decision, woken);
  diagnostics_.on_quiet(decision);
}

/// Why the robot stands whatever was seen last.
std::optional<Doubt> SafetyNode::doubt_without_cloud() {
  if (auto doubt = commands_.doubt()) return doubt;
  if (camera_.has_sent()) return std::nullopt;
  return lost_things_.nothing_seen(camera_.why_nothing_came());
}

/// What makes a cloud no reason to drive, whatever it shows.
std::optional<Doubt> SafetyNode::doubt_about(const std_msgs::Header& cloud, const Instant& came) {
  if (auto doubt = commands_.doubt()) return doubt;
  return gap_.doubt_about(cloud.stamp.toSec(), came, control_.settings());
}

/// The next command is due after a period without one, or the moment the camera counts as silent if that is sooner:
/// from when this one was decided, for the process may have stood still since.
void SafetyNode::publish(const Decision& decision, const Instant& decided) {
  const double period = 1.0 / control_.settings().publish_rate;
  const double until_silent = last_cloud_ ? control_.settings().source_timeout - (decided.steady - *last_cloud_) : 0.0;
  quiet_.in(until_silent > 0.0 ? std::min(period, until_silent) : period);
  const double valid = until_silent > 0.0 ? until_silent : period;
  commands_.publish(to_twist(decision), decided.steady + valid);
  reports_.say(decision, control_.settings(), header_);
  if (const auto line = commands_.unheard()) log_.warn(*line);
  lost_things_.keep(decision.cause);
  said_ = decision.cause;
}

}  // namespace safety_control_cloud
