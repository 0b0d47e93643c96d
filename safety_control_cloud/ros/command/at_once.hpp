// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

namespace safety_control_cloud {

/// No queue at all: a callback is called where it would wait, by the thread that received or published. It must not
/// publish on its own topic, whose subscription is locked meanwhile.
class AtOnce : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t) override { callback->call(); }
  void removeByID(std::uint64_t) override {}
};

}  // namespace safety_control_cloud
