// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

#include <functional>
#include <utility>

namespace safety_control_cloud {

/// Work that waits in a queue of roscpp's.
class Later : public ros::CallbackInterface {
 public:
  explicit Later(std::function<void()> work) : work_(std::move(work)) {}

  CallResult call() override {
    work_();
    return Success;
  }

 private:
  std::function<void()> work_;
};

}  // namespace safety_control_cloud
