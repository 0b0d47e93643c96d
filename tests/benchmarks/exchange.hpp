// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/ros.h>

#include <functional>
#include <vector>

namespace safety_control_cloud {

/// What followed one cloud.
struct Answer {
  double latency = 0.0;  ///< [s] from just before its publishing to the first Twist; 0 without one
  int twists = 0;        ///< until the next cloud
  double speed = 0.0;    ///< [m/s] of the latest
};

/// Where clouds come from.
struct CloudSource {
  std::function<void()> prepare;  ///< the next one, as a driver does; no part of the latency
  std::function<void()> publish;
};

/// Shows a node clouds at a rate, the next only after the answer to the last, and times the answers.
/// Its callbacks run in the thread that calls it.
class Exchange {
 public:
  /// `rate` in Hz.
  Exchange(const ros::Publisher& clouds, double rate);

  /// Waits until the node hears the clouds and is heard. Throws std::runtime_error if it does not come.
  void meet();

  /// The answers to so many clouds. Ends a period after the last.
  std::vector<Answer> show(int clouds, const CloudSource& source);

 private:
  void on_twist(const geometry_msgs::Twist& twist);
  void hear_until(const ros::SteadyTime& end, const std::function<bool()>& enough);

  ros::Publisher clouds_;
  ros::Subscriber twists_;
  ros::WallDuration period_;
  ros::SteadyTime published_;
  Answer answer_;
};

}  // namespace safety_control_cloud
