// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

namespace safety_control_cloud {

/// A queue into another one, whose callbacks let what already waits there go first. Needs no thread of its own.
class AfterOthers : public ros::CallbackQueueInterface {
 public:
  explicit AfterOthers(ros::CallbackQueueInterface& queue) : queue_(queue) {}

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) override;
  void removeByID(std::uint64_t owner) override { queue_.removeByID(owner); }

 private:
  ros::CallbackQueueInterface& queue_;
};

}  // namespace safety_control_cloud
