// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/time.h>

#include <functional>
#include <mutex>
#include <thread>

#include "steady_condition.hpp"

namespace safety_control_cloud {

/// Calls back at a moment that is put off again and again. To put it off costs nothing: the thread that waits for it is
/// left to wake too early, and then waits on. (Each change of a timer of roscpp's wakes two threads.)
class Wake {
 public:
  /// `call` runs in the queue.
  Wake(ros::CallbackQueueInterface& queue, std::function<void()> call);
  ~Wake();

  /// In so many seconds from now, and not at the moment said before.
  void in(double seconds);

 private:
  void watch();
  void on_due();

  ros::CallbackQueueInterface& queue_;
  const std::function<void()> call_;
  std::mutex mutex_;
  SteadyCondition sooner_;
  ros::SteadyTime due_;    ///< zero: at no time
  ros::SteadyTime wakes_;  ///< when the thread will see by itself what is due; zero: never
  bool leave_ = false;
  std::thread thread_;
};

}  // namespace safety_control_cloud
