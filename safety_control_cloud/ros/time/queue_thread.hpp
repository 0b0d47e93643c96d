// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>

#include <atomic>
#include <exception>
#include <functional>
#include <thread>

namespace safety_control_cloud {

/// Calls what comes into a queue, in a thread of its own, as a ros::AsyncSpinner of one thread does. What that throws
/// is told to `caught`: out of a spinner's thread it would end the process, and all nodelets in it, with whatever they
/// commanded last.
class QueueThread {
 public:
  using Caught = std::function<bool(const std::exception&)>;  ///< whether to go on

  /// Borrows the queue. `caught` is called in the thread.
  QueueThread(ros::CallbackQueue& queue, Caught caught);
  ~QueueThread();  ///< once what is being called has returned
  QueueThread(const QueueThread&) = delete;
  QueueThread& operator=(const QueueThread&) = delete;

 private:
  void call();

  ros::CallbackQueue& queue_;
  const Caught caught_;
  std::atomic<bool> leave_{false};
  std::thread thread_;
};

}  // namespace safety_control_cloud
