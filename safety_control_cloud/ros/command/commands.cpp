// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include <ros/this_node.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <utility>

#include "../time/later.hpp"

namespace safety_control_cloud {
namespace {

constexpr double period = 0.1;  ///< [s] between two looks at who is connected; not longer than a node may be late
constexpr double slack = 0.1;   ///< [s] by which the node may be late
constexpr double unheard_after = 5.0;  ///< [s]
constexpr double repetition = 0.1;     ///< [s] between two zeros where the node says nothing

/// Whose message this thread is publishing now. In one process all that is published bears the same name; but a pointer
/// is handed over before publish() returns.
thread_local const Commands* speaker = nullptr;

double now() { return ros::SteadyTime::now().toSec(); }

/// NaN is no zero.
bool is_zero(const geometry_msgs::Twist& twist) {
  const auto &linear = twist.linear, &angular = twist.angular;
  return linear.x == 0 && linear.y == 0 && linear.z == 0 && angular.x == 0 && angular.y == 0 && angular.z == 0;
}

}  // namespace

Commands::Commands(ros::NodeHandle& handle, const std::string& topic, std::function<void()> on_other)
    : others_(handle.resolveName(topic)),
      connected_(handle.resolveName(topic)),
      queue_(*handle.getCallbackQueue()),
      on_other_(std::move(on_other)),
      heard_(now()),
      publisher_(handle.advertise<Twist>(topic, 1)) {
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const ros::MessageEvent<const Twist>&>(
      topic, 10, [this](const ros::MessageEvent<const Twist>& event) { on_message(event); });
  options.callback_queue = &at_once_;
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  subscriber_ = handle.subscribe(options);
  stand();
  thread_ = std::thread([this] { watch(); });
}

Commands::~Commands() {
  end();
  {
    const std::lock_guard<std::mutex> lock(waking_);
    leave_ = true;
  }
  woken_.notify_all();
  thread_.join();
  subscriber_.shutdown();
  queue_.removeByID(reinterpret_cast<std::uint64_t>(this));
}

void Commands::publish(const Twist& wanted, double due) {
  const bool alone = !others_.doubt(now());
  const std::lock_guard<std::mutex> lock(saying_);
  due_ = due + slack;
  say(alone && !ended_ && now() < due_ ? wanted : Twist());
}

std::optional<Doubt> Commands::doubt() { return others_.doubt(now()); }

std::optional<std::string> Commands::unheard() {
  const bool is_unheard = now() - heard_ > unheard_after, said = std::exchange(said_unheard_, is_unheard);
  if (said || !is_unheard) return std::nullopt;
  return "nobody listens on " + publisher_.getTopic() + ": a base that obeys another topic passes this node by";
}

void Commands::end() {
  const std::lock_guard<std::mutex> lock(saying_);
  ended_ = true;
  say(Twist());
}

/// In the thread that received it, or in the one that published it if that is of this process.
void Commands::on_message(const ros::MessageEvent<const Twist>& event) {
  if (speaker == this) return;
  const bool own_process = event.getPublisherName() == ros::this_node::getName();
  others_.heard(own_process ? "another part of " + event.getPublisherName() : event.getPublisherName(), now());
  if (is_zero(*event.getConstMessage())) return;
  {
    const std::lock_guard<std::mutex> lock(waking_);
    answer_ = true;
  }
  woken_.notify_all();
}

/// Sleeps until something is due: each time that it wakes costs as much as a look at some thousand points.
void Commands::watch() {
  double until = 0.0;
  std::unique_lock<std::mutex> lock(waking_);
  while (!leave_) {
    const double left = until - now();
    if (!answer_ && left > 0.0) woken_.wait_for(lock, for_seconds(left));
    const bool answer = std::exchange(answer_, false);
    lock.unlock();
    if (answer) stand();
    look_who_is_connected();
    until = std::min(stand_if_overdue(), now() + period);
    lock.lock();
  }
}

void Commands::look_who_is_connected() {
  const std::size_t all = subscriber_.getNumPublishers();  // this process is one of them
  others_.connected(connected_.names(all > 1 ? all - 1 : 0));
  if (publisher_.getNumSubscribers() > 1) heard_ = now();  // itself, too
  const bool known = std::exchange(other_known_, others_.doubt(now()).has_value());
  if (other_known_ && !known) {
    queue_.addCallback(boost::make_shared<Later>(on_other_), reinterpret_cast<std::uint64_t>(this));
  }
}

/// When zero is due next. What the node says meanwhile puts it off, or sets it no sooner than a period from then.
double Commands::stand_if_overdue() {
  const std::lock_guard<std::mutex> lock(saying_);
  if (now() >= due_ && !ended_) {
    due_ = now() + repetition;
    say(Twist());
  }
  return ended_ ? now() + repetition : due_;
}

void Commands::stand() {
  const std::lock_guard<std::mutex> lock(saying_);
  say(Twist());
}

void Commands::say(const Twist& twist) {
  speaker = this;
  publisher_.publish(boost::make_shared<Twist>(twist));
  speaker = nullptr;
}

}  // namespace safety_control_cloud
