// SPDX-License-Identifier: BSD-3-Clause
#include "safety_node.hpp"

#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <utility>

#include "command/leaving.hpp"
#include "input/inputs.hpp"
#include "moments.hpp"
#include "output/messages.hpp"

namespace safety_control_cloud {
namespace {

constexpr double shortest_wait = 1e-3;  ///< [s] so that a timer that is due does not spin
constexpr double reset_period = 1.0;    ///< [s] a program that resets again and again is as good as no memory
constexpr double kept_period = 0.5;     ///< [s] after which what is near is written down though the cause is the same
constexpr char nothing_known[] = "the ROS master tells nothing of what was near before this start";
constexpr double slack = 0.1;  ///< [s] by which the node may be late until another thread commands zero

}  // namespace

SafetyNode::SafetyNode(ros::NodeHandle handle, ros::NodeHandle private_handle, Delivery delivery,
                       const Settings& settings)
    : control_(settings),
      awaited_(wanted_by(control_.settings().input, handle, private_handle)),
      keepsake_(private_handle, [this](const std::string& line) { log_.warn(line); }),
      commands_(handle, "cmd_vel_mux/input/teleop", [this] { on_quiet(); }),
      output_(handle.advertise<sensor_msgs::PointCloud2>("output", 1)),
      reports_(private_handle, log_),
      reset_(private_handle.advertiseService("reset", &SafetyNode::on_reset, this)),
      reconfigure_(
          private_handle, settings, [this](const Settings& changed) { control_.adopt(changed); }, log_),
      diagnostics_(handle, private_handle) {
  const bool recalled = keepsake_.found() && control_.recall(*keepsake_.found());
  const std::string& target_frame = control_.settings().target_frame;
  if (!target_frame.empty()) camera_place_ = std::make_unique<CameraPlace>(target_frame);
  constexpr bool once = true, not_yet = false;
  const auto wake = [this](const ros::SteadyTimerEvent&) { on_quiet(); };
  quiet_ = handle.createSteadyTimer(ros::WallDuration(1.0), wake, once, not_yet);
  if (!recalled) log_.warn(nothing_known);
  on_quiet();
  input_ = input_of(
      control_.settings().input, handle, private_handle, delivery,
      [this](const Arrival& arrival) { on_arrival(arrival); }, [this](const std::string& line) { log_.warn(line); });
}

SafetyNode::~SafetyNode() {
  commands_.end();
  let_it_leave();
}

void SafetyNode::on_arrival(const Arrival& arrival) {
  if (last_cloud_.isZero()) log_.info(std::string(input_->what()) + " arrived");
  awaited_.has_come();
  beat();
  const double silence = last_cloud_.isZero() ? 0.0 : seconds_since(last_cloud_);
  const bool silence_was_said = said_ == Cause::Silent;
  if (silence > control_.settings().source_timeout && !silence_was_said) publish(control_.without_cloud(now()));
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
  Origin origin{arrival.header.stamp.toSec(), OpticalFrame{}, arrival.source, arrival.header.frame_id};
  control_.note_outside(doubt_about(arrival.header));
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

void SafetyNode::on_quiet() {
  beat();
  control_.note_outside(doubt_without_cloud());
  Decision decision = control_.without_cloud(now());
  if (decision.cause == Cause::NoCloud) decision.reason += "; " + awaited_.why();
  publish(decision);
  diagnostics_.on_quiet(decision);
}

bool SafetyNode::on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& answer) {
  answer.success = last_reset_.isZero() || seconds_since(last_reset_) >= reset_period;
  answer.message = answer.success ? "near obstacles lost from sight are forgotten"
                                  : "refused: near obstacles are forgotten at most once a second";
  log_.warn("~reset: " + answer.message);
  if (!answer.success) return true;
  last_reset_ = ros::SteadyTime::now();
  control_.forget_losses();
  keepsake_.keep(control_.remembered());
  reports_.count_reset();
  return true;
}

void SafetyNode::beat() {
  const Instant moment = now();
  gap_.beat(moment.steady, moment.ros, longest_gap(control_.settings()));
}

/// Why the robot stands whatever was seen last.
std::optional<Doubt> SafetyNode::doubt_without_cloud() {
  if (auto doubt = commands_.doubt()) return doubt;
  if (!last_cloud_.isZero() || keepsake_.found()) return std::nullopt;
  return Doubt{Cause::NoCloud, std::string("no cloud has arrived yet, and ") + nothing_known};
}

/// What makes a cloud no reason to drive, whatever it shows.
std::optional<Doubt> SafetyNode::doubt_about(const std_msgs::Header& cloud) {
  if (auto doubt = commands_.doubt()) return doubt;
  const Settings& settings = control_.settings();
  if (settings.stamp_tolerance <= 0.0) return std::nullopt;  // no stamp is to be believed
  return gap_.doubt_about(cloud.stamp.toSec(), now().steady, longest_gap(settings));
}

void SafetyNode::publish(const Decision& decision) {
  wake_when_quiet();
  const double valid = std::max(source_timeout_left(), 1.0 / control_.settings().publish_rate);
  commands_.publish(to_twist(decision), now().steady + valid + slack);
  reports_.say(decision, control_.settings(), header_);
  keep_what_is_near(decision);
  said_ = decision.cause;
}

void SafetyNode::keep_what_is_near(const Decision& decision) {
  if (decision.cause == said_ && seconds_since(last_kept_) < kept_period) return;
  keepsake_.keep(control_.remembered());
  last_kept_ = ros::SteadyTime::now();
}

/// The next command is due after a period without one, or the moment the camera counts as silent if that is sooner.
void SafetyNode::wake_when_quiet() {
  double wait = 1.0 / control_.settings().publish_rate;
  const double until_silent = source_timeout_left();
  if (until_silent > 0.0) wait = std::min(wait, until_silent + shortest_wait);
  quiet_.stop();
  quiet_.setPeriod(ros::WallDuration(std::max(wait, shortest_wait)));
  quiet_.start();
}

/// [s]; negative once the camera is silent.
double SafetyNode::source_timeout_left() const {
  return control_.settings().source_timeout - seconds_since(last_cloud_);
}

}  // namespace safety_control_cloud
