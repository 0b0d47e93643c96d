// SPDX-License-Identifier: BSD-3-Clause
#include "guard_node.hpp"

#include <algorithm>
#include <cmath>

#include "command/leaving.hpp"
#include "input/inputs.hpp"
#include "moments.hpp"
#include "output/guard_messages.hpp"

namespace safety_control_cloud {
namespace {

constexpr double shortest_wait = 1e-3;  ///< [s] so that a timer that is due does not spin
constexpr double reset_period = 1.0;    ///< [s] a program that resets again and again is as good as no memory
constexpr double kept_period = 0.5;     ///< [s] after which what is near is written down though the cause is the same
constexpr double slack = 0.1;           ///< [s] by which the node may be late until another thread commands zero

Pose2 to_pose(const geometry_msgs::Pose& pose) {
  const auto& turn = pose.orientation;
  const double heading =
      std::atan2(2.0 * (turn.w * turn.z + turn.x * turn.y), 1.0 - 2.0 * (turn.y * turn.y + turn.z * turn.z));
  return {{pose.position.x, pose.position.y}, heading};
}

}  // namespace

GuardNode::GuardNode(ros::NodeHandle handle, ros::NodeHandle private_handle, Delivery delivery,
                     const Settings& settings)
    : control_(settings),
      keepsake_(private_handle, [this](const std::string& line) { log_.warn(line); }),
      commands_(handle, "cmd_vel", [this] { on_quiet(); }),
      base_(settings.base_frame),
      reports_(private_handle, log_),
      reset_(private_handle.advertiseService("reset", &GuardNode::on_reset, this)),
      reconfigure_(
          private_handle, settings, [this](const Settings& changed) { control_.adopt(changed); }, log_),
      diagnostics_(handle, private_handle) {
  if (keepsake_.found()) control_.recall(*keepsake_.found());
  constexpr bool once = true, not_yet = false;
  const auto wake = [this](const ros::SteadyTimerEvent&) { on_quiet(); };
  quiet_ = handle.createSteadyTimer(ros::WallDuration(1.0), wake, once, not_yet);
  on_quiet();
  const auto at_once = ros::TransportHints().tcpNoDelay();
  wanted_ = handle.subscribe<geometry_msgs::Twist>(
      "cmd_vel_in", 1,
      boost::function<void(const geometry_msgs::Twist::ConstPtr&)>(
          [this](const geometry_msgs::Twist::ConstPtr& wanted) { on_wanted(*wanted); }),
      nullptr, at_once);
  odometry_ = handle.subscribe<nav_msgs::Odometry>(
      "odom", 10,
      boost::function<void(const nav_msgs::Odometry::ConstPtr&)>(
          [this](const nav_msgs::Odometry::ConstPtr& odometry) { on_odometry(*odometry); }),
      nullptr, at_once);
  input_ = input_of(
      settings.input, handle, private_handle, delivery, [this](const Arrival& arrival) { on_arrival(arrival); },
      [this](const std::string& line) { log_.warn(line); });
}

GuardNode::~GuardNode() {
  commands_.end();
  let_it_leave();
}

void GuardNode::on_wanted(const geometry_msgs::Twist& wanted) {
  beat();
  control_.want(to_command(wanted), now());
  publish(answer());
}

void GuardNode::on_arrival(const Arrival& arrival) {
  if (last_cloud_.isZero()) log_.info(std::string(input_->what()) + " arrived");
  beat();
  last_cloud_ = ros::SteadyTime::now();
  header_ = arrival.header;
  about_cloud_ = doubt_about(arrival.header);
  see(arrival);
  const Guarded& decided = answer();
  const double decision_time = seconds_since(last_cloud_), latency = age_of(header_);
  const bool changes = !same_bits(to_twist(decided.given), said_) || decided.cause != said_cause_;
  if (changes) publish(decided);
  diagnostics_.on_cloud(to_decision(decided), header_, decision_time, latency);
}

/// The one border where an exception becomes a doubt: whatever went wrong, the robot stands.
void GuardNode::see(const Arrival& arrival) {
  Origin origin{arrival.header.stamp.toSec(), OpticalFrame{}, arrival.source, arrival.header.frame_id};
  try {
    origin.placing = base_.at(arrival.header);
    control_.see(arrival.reading, origin, now());
  } catch (const std::exception& problem) {
    control_.see(Unreadable{problem.what()}, origin, now());
  }
}

void GuardNode::on_odometry(const nav_msgs::Odometry& odometry) {
  const std::string& base = control_.settings().base_frame;
  if (odometry.child_frame_id != base && !warned_of_frame_) {
    log_.warn("odometry is of " + odometry.child_frame_id + "; it is taken for that of " + base +
              ", which must differ from it in height alone");
    warned_of_frame_ = true;
  }
  const auto& twist = odometry.twist.twist;
  control_.note_odometry(odometry.header.stamp.toSec(), to_pose(odometry.pose.pose),
                         {twist.linear.x, twist.linear.y, twist.angular.z});
}

void GuardNode::on_quiet() {
  beat();
  const Guarded& decided = answer();
  publish(decided);
  diagnostics_.on_quiet(to_decision(decided));
}

bool GuardNode::on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& answer) {
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

const Guarded& GuardNode::answer() {
  const auto commanders = commands_.doubt();
  control_.note_outside(commanders ? commanders : about_cloud_);
  return control_.answer(now());
}

void GuardNode::publish(const Guarded& answer) {
  wake_when_quiet();
  said_ = to_twist(answer.given);
  commands_.publish(said_, now().steady + period() + slack);
  reports_.say(answer, control_.settings(), header_);
  keep_what_is_near(answer);
  said_cause_ = answer.cause;
}

void GuardNode::keep_what_is_near(const Guarded& answer) {
  if (answer.cause == said_cause_ && seconds_since(last_kept_) < kept_period) return;
  keepsake_.keep(control_.remembered());
  last_kept_ = ros::SteadyTime::now();
}

void GuardNode::beat() {
  const Instant moment = now();
  gap_.beat(moment.steady, moment.ros, longest_gap(control_.settings()));
}

/// What makes a cloud no reason to drive, whatever it shows.
std::optional<Doubt> GuardNode::doubt_about(const std_msgs::Header& cloud) const {
  const Settings& settings = control_.settings();
  if (settings.stamp_tolerance <= 0.0) return std::nullopt;  // no stamp is to be believed
  return gap_.doubt_about(cloud.stamp.toSec(), now().steady, longest_gap(settings));
}

/// [s] after which there is a new answer: data grow older, and the law counts on one that is no older than a cloud.
double GuardNode::period() const {
  const Settings& settings = control_.settings();
  return std::max(0.01, std::min(1.0 / settings.publish_rate, settings.stopping.sensor_period));
}

/// Or once the camera counts as silent, if that is sooner.
void GuardNode::wake_when_quiet() {
  const double until_silent = control_.settings().source_timeout - seconds_since(last_cloud_);
  const double wait = until_silent > 0.0 ? std::min(period(), until_silent + shortest_wait) : period();
  quiet_.stop();
  quiet_.setPeriod(ros::WallDuration(std::max(wait, shortest_wait)));
  quiet_.start();
}

}  // namespace safety_control_cloud
