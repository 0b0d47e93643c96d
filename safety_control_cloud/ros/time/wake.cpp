// SPDX-License-Identifier: BSD-3-Clause
#include "wake.hpp"

#include <boost/make_shared.hpp>
#include <cstdint>
#include <utility>

#include "later.hpp"

namespace safety_control_cloud {

Wake::Wake(ros::CallbackQueueInterface& queue, std::function<void()> call)
    : queue_(queue), call_(std::move(call)), thread_([this] { watch(); }) {}

Wake::~Wake() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    leave_ = true;
  }
  sooner_.notify_all();
  thread_.join();
  queue_.removeByID(reinterpret_cast<std::uint64_t>(this));
}

void Wake::in(double seconds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  due_ = ros::SteadyTime::now() + ros::WallDuration(seconds);
  if (wakes_.isZero() || due_ < wakes_) sooner_.notify_all();
}

void Wake::watch() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!leave_) {
    wakes_ = due_;
    const ros::WallDuration left = due_ - ros::SteadyTime::now();
    if (due_.isZero()) {
      sooner_.wait(lock);
    } else if (left > ros::WallDuration()) {
      sooner_.wait_for(lock, for_seconds(left.toSec()));
    } else {
      due_ = ros::SteadyTime();
      lock.unlock();
      queue_.addCallback(boost::make_shared<Later>([this] { on_due(); }), reinterpret_cast<std::uint64_t>(this));
      lock.lock();
    }
  }
}

/// In the queue, where it may have waited until it was put off.
void Wake::on_due() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!due_.isZero()) return;
  }
  call_();
}

}  // namespace safety_control_cloud
