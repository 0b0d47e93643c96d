// SPDX-License-Identifier: BSD-3-Clause
#include "wake.hpp"

#include <algorithm>
#include <utility>

namespace safety_control_cloud {
namespace {

constexpr double shortest = 1e-3;     ///< [s] so that a timer that is due does not spin
constexpr double longest_wait = 0.1;  ///< [s] in the queue; of what comes later nobody knows whether it will

}  // namespace

Wake::Wake(ros::NodeHandle& handle, std::function<void()> call)
    : call_(std::move(call)), timer_([this, &handle] {
        constexpr bool once = true, not_yet = false;
        return handle.createSteadyTimer(
            ros::WallDuration(1.0), [this](const ros::SteadyTimerEvent&) { on_timer(); }, once, not_yet);
      }()) {}

void Wake::in(double seconds) {
  const double wait = std::max(seconds, shortest);
  const ros::SteadyTime now = ros::SteadyTime::now();
  due_ = now + ros::WallDuration(wait);
  const bool is_overdue = now - fires_ > ros::WallDuration(longest_wait);
  if (fires_.isZero() || due_ < fires_ || is_overdue) set_timer(wait);
}

void Wake::on_timer() {
  fires_ = ros::SteadyTime();
  const double left = (due_ - ros::SteadyTime::now()).toSec();
  left > 0.0 ? set_timer(std::max(left, shortest)) : call_();
}

void Wake::set_timer(double seconds) {
  timer_.stop();
  timer_.setPeriod(ros::WallDuration(seconds));
  timer_.start();
  fires_ = ros::SteadyTime::now() + ros::WallDuration(seconds);
}

}  // namespace safety_control_cloud
