// SPDX-License-Identifier: BSD-3-Clause
#include "queue_thread.hpp"

#include <utility>

namespace safety_control_cloud {
namespace {

constexpr double period = 0.1;  ///< [s] after which the thread asks whether it should leave

}  // namespace

QueueThread::QueueThread(ros::CallbackQueue& queue, Caught caught)
    : queue_(queue), caught_(std::move(caught)), thread_([this] { call(); }) {}

QueueThread::~QueueThread() {
  leave_ = true;
  thread_.join();
}

/// One by one: what callAvailable() has taken along and not called, as something threw, it leaves until more comes.
void QueueThread::call() {
  while (!leave_) {
    try {
      queue_.callOne(ros::WallDuration(period));
    } catch (const std::exception& problem) {
      if (!caught_(problem)) return;
    }
  }
}

}  // namespace safety_control_cloud
