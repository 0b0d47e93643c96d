// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/callback_queue_interface.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "../../core/doubt/doubt.hpp"
#include "../graph/connected.hpp"
#include "../time/steady_condition.hpp"
#include "at_once.hpp"
#include "other_commanders.hpp"

namespace safety_control_cloud {

/// The topic that commands the robot: what the node says on it, what others say, and what is said if the node does not.
///
/// A thread of its own says zero where the node is late (its thread may be blocked by a terminal, by other nodelets, by
/// anything) and answers each command of somebody else with a zero. That thread waits for nobody: it never logs, never
/// asks the master and runs no callback. Two nodes do not answer each other's zeros.
class Commands {
 public:
  using Twist = geometry_msgs::Twist;

  /// The first zero goes out before this returns. `on_other` is called in the handle's queue when somebody else comes.
  Commands(ros::NodeHandle& handle, const std::string& topic, std::function<void()> on_other);
  ~Commands();

  /// Says `wanted`, or zero if somebody else commands the robot too. The next one is `due` at [s, steady]: if none
  /// is published until shortly after that, zero is said, and again from then on. What is late itself is zero too.
  void publish(const Twist& wanted, double due);

  /// Whether somebody else commands the robot.
  std::optional<Doubt> doubt();

  /// That nobody has listened for some seconds, in words, once until somebody does.
  std::optional<std::string> unheard();

  /// The last command: nothing but zero is said from now on.
  void end();

 private:
  void on_message(const ros::MessageEvent<const Twist>& event);
  void watch();
  void look_who_is_connected();
  double stand_if_overdue();
  void stand();
  void say(const Twist& twist);

  OtherCommanders others_;
  Connected connected_;
  AtOnce at_once_;
  ros::CallbackQueueInterface& queue_;
  const std::function<void()> on_other_;

  std::mutex saying_;  ///< never held by who is called back by roscpp, which has locked the topic then
  double due_ = 0.0;
  bool ended_ = false;

  std::mutex waking_;
  SteadyCondition woken_;
  bool answer_ = false, leave_ = false;

  bool other_known_ = false;   ///< of the thread alone
  std::atomic<double> heard_;  ///< [s, steady] when somebody else listened last
  bool said_unheard_ = false;  ///< of the node's thread alone
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
  std::thread thread_;
};

}  // namespace safety_control_cloud
