// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <functional>

namespace safety_control_cloud {

/// Calls back at a moment that is put off again and again. To put it off costs nothing: roscpp's timer, which wakes a
/// thread at each change, is left to fire too early, and then set anew.
class Wake {
 public:
  /// `call` runs in the handle's queue.
  Wake(ros::NodeHandle& handle, std::function<void()> call);

  /// In so many seconds from now, and not at the moment said before.
  void in(double seconds);

 private:
  void on_timer();
  void set_timer(double seconds);

  const std::function<void()> call_;
  ros::SteadyTime due_, fires_;  ///< fires_: zero if the timer is not set
  ros::SteadyTimer timer_;
};

}  // namespace safety_control_cloud
