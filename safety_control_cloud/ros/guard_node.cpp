// SPDX-License-Identifier: BSD-3-Clause
#include "guard_node.hpp"

#include <algorithm>
#include <stdexcept>

#include "command/leaving.hpp"
#include "graph/named_in.hpp"
#include "input/footprint_message.hpp"
#include "input/wanted.hpp"
#include "output/guard_messages.hpp"
#include "time/moments.hpp"

namespace safety_control_cloud {
namespace {

std::vector<std::string> names_of(const Sensors& sensors) {
  std::vector<std::string> names;
  for (const SensorSettings& sensor : sensors) names.push_back(sensor.name);
  return names.empty() ? std::vector<std::string>{""} : names;
}

std::vector<std::unique_ptr<Channel>> channels_of(const Settings& settings, const ros::NodeHandle& handle,
                                                  const ros::NodeHandle& private_handle) {
  std::vector<std::unique_ptr<Channel>> channels;
  for (const SensorSettings& sensor : sensors_of(settings))
    channels.push_back(std::make_unique<Channel>(sensor, handle, private_handle));
  return channels;
}

}  // namespace

GuardNode::GuardNode(ros::NodeHandle handle, ros::NodeHandle private_handle, Delivery delivery,
                     const Settings& settings)
    : control_(settings),
      channels_(channels_of(settings, handle, private_handle)),
      commands_(handle, named_in(handle, "cmd_vel"), [this] { on_quiet(); }),
      base_(settings.base_frame, log_.warner()),
      reports_(private_handle, log_),
      lost_things_(private_handle, LostThings::of(control_, reports_), log_.warner(),
                   [this] { return may_have_waited(now()); }),
      quiet_(*handle.getCallbackQueue(), [this] { on_quiet(); }),
      reconfigure_(
          private_handle, settings,
          [this](Settings changed) {
            changed.footprint = control_.settings().footprint;  // ~footprint's, where that spoke
            control_.adopt(changed);
          },
          log_),
      diagnostics_(handle, private_handle, log_.warner(), names_of(settings.sensors)) {
  on_quiet();
  odometry_.emplace(
      handle, control_, base_.buffer(), [this] { beat(now()); }, log_.warner());
  override_ = private_handle.advertiseService("override", &GuardNode::on_override, this);
  wanted_ = subscribe_to_wanted(
      handle, settings.command_type,
      [this](const geometry_msgs::Twist& wanted, std::optional<double> stamp) { on_wanted(wanted, stamp); },
      [this](const std::string& publisher) {
        log_.warn(publisher +
                  " latches its commands: the first over a connection may be of long ago, and is not obeyed");
      });
  footprint_ = private_handle.subscribe<geometry_msgs::PolygonStamped>(
      "footprint", 1,
      boost::function<void(const geometry_msgs::PolygonStamped::ConstPtr&)>(
          [this](const geometry_msgs::PolygonStamped::ConstPtr& polygon) { on_footprint(*polygon); }));
  for (const SwitchSettings& one : settings.switches) {
    const std::size_t which = switches_.size();
    switches_.push_back(std::make_unique<SwitchInput>(
        handle, one,
        [this, which](const std::string& who, Edge edge, bool touched) { on_switch(which, who, edge, touched); },
        [this, which](const auto& living) { control_.note_switch_living(which, living.names, living.as_of); }));
  }
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    channels_[i]->open(
        handle, private_handle, delivery, [this, i](const Arrival& arrival) { on_arrival(i, arrival); },
        log_.informer(), log_.warner());
  }
}

GuardNode::~GuardNode() {
  commands_.end();
  let_it_leave();
}

void GuardNode::on_wanted(const geometry_msgs::Twist& wanted, std::optional<double> stamp) {
  const Instant came = now();
  const bool waited = may_have_waited(came), may_be_old = !stamp && waited;
  if (!may_be_old) control_.want(to_command(wanted), came, stamp);
  publish(answer());
}

void GuardNode::beat(const Instant& now) {
  if (const auto gap = gap_.beat(now, control_.settings())) control_.note_deafness(*gap, now);
}

/// What has no stamp, and waited in a socket while the process stood still, is told from nothing.
bool GuardNode::may_have_waited(const Instant& came) {
  beat(came);
  return gap_.has_gone_on_within(control_.settings().command_timeout, came);
}

void GuardNode::on_arrival(std::size_t sensor, const Arrival& arrival) {
  const Instant came = now();
  beat(came);
  header_ = arrival.header;
  see(sensor, arrival, came);
  const Guarded& decided = answer();
  const double decision_time = seconds_since(came), latency = age_of(header_);
  if (changes(decided)) publish(decided);
  diagnostics_.on_cloud(to_decision(decided), header_, decision_time, latency, sensor);
}

/// Here, and in answer_now(), an exception becomes a doubt: whatever went wrong, the robot stands.
void GuardNode::see(std::size_t sensor, const Arrival& arrival, const Instant& came) {
  const double stamp = arrival.header.stamp.toSec();
  Origin origin{stamp, OpticalFrame{}, arrival.source, arrival.header.frame_id};
  control_.note_about(sensor, gap_.doubt_about(stamp, came, control_.settings()));
  odometry_->ask();
  try {
    origin.placing = base_.at(arrival.header);
    control_.see(arrival.reading, origin, came, sensor);
  } catch (const std::exception& problem) {
    control_.see(Unreadable{problem.what()}, origin, came, sensor);
  }
}

void GuardNode::on_switch(std::size_t which, const std::string& who, Edge edge, bool touched) {
  const Instant came = now();
  beat(came);
  if (!control_.note_switch(which, who, edge, touched, came)) return;
  const Guarded& decided = answer();
  if (changes(decided)) publish(decided);
}

/// Whole or not at all. What was collected for another outline is of no use: the robot stands until the next cloud.
void GuardNode::on_footprint(const geometry_msgs::PolygonStamped& polygon) {
  Settings changed = control_.settings();
  try {
    const Lists corners = footprint_in(polygon, changed.base_frame);
    if (corners == changed.footprint) return;
    changed.footprint = corners;
    control_.adopt(changed);
  } catch (const std::invalid_argument& problem) {
    return log_.error(std::string("~footprint: refused, the one before stays: ") + problem.what());
  }
  log_.warn("~footprint: from now on " + changed.footprint.text);
  publish(answer());
}

void GuardNode::on_quiet() {
  beat(now());
  const Guarded& decided = answer();
  publish(decided);
  diagnostics_.on_quiet(to_decision(decided));
}

bool GuardNode::on_override(OverrideRequest& wish, OverrideResponse& response) {
  const Instant came = now();
  const OverrideReply reply = may_have_waited(came)
                                  ? OverrideReply{false, "refused: this node had stood still until just now; ask again"}
                                  : control_.ask_override({wish.seconds, wish.speed, wish.even_in_doubt != 0}, came);
  response.success = reply.granted;
  response.message = reply.words;
  log_.warn("~override: " + reply.words);
  publish(answer());
  return true;
}

const Guarded& GuardNode::answer() {
  if (odometry_) odometry_->ask();
  control_.note_outside(commands_.doubt());
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (!channels_[i]->has_sent()) control_.note_about(i, lost_things_.nothing_seen(channels_[i]->why_nothing_came()));
  }
  for (std::size_t i = 0; i < switches_.size(); ++i) {
    switches_[i]->note_publishers();
    control_.note_about_switch(i, switches_[i]->doubt());
  }
  answered_at_ = now();
  const Guarded& answer = answer_now();
  diagnostics_.note_override(answer.override_left);
  return answer;
}

const Guarded& GuardNode::answer_now() {
  try {
    return control_.answer(answered_at_);
  } catch (const std::exception& problem) {
    return control_.stand(answered_at_, {Cause::Unreadable, problem.what()});
  }
}

bool GuardNode::changes(const Guarded& answer) const {
  return !same_bits(to_twist(answer.given), said_) || answer.cause != said_cause_;
}

/// The next answer is due after a period, or once a sensor counts as silent or an override ends, if that is sooner:
/// from when this one was given, for the process may have stood still since.
void GuardNode::publish(const Guarded& answer) {
  const double until_silent = control_.until_silent(answered_at_.steady);
  double due = control_.answer_period();
  for (const double change : {until_silent, answer.override_left})
    if (change > 0.0) due = std::min(due, change);
  quiet_.in(due);
  said_ = to_twist(answer.given);
  commands_.publish(said_, answered_at_.steady + due);
  reports_.say(answer, control_.settings(), header_);
  if (const auto line = commands_.unheard()) log_.warn(*line);
  lost_things_.keep(answer.cause);
  said_cause_ = answer.cause;
}

}  // namespace safety_control_cloud
