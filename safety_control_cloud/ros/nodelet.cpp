// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/detail/callback_queue.h>
#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "command/last_word.hpp"
#include "nodes.hpp"

namespace safety_control_cloud {

namespace {

/// nodelet 1.10.0 (Debian 11, Noetic of 2020) keeps the queues shut until onInit returns, and throws away what comes
/// meanwhile; the timer or the subscription that it came from is then dead for good (ros/nodelet_core#106).
void open(ros::CallbackQueueInterface& queue) {
  if (auto* own = dynamic_cast<nodelet::detail::CallbackQueue*>(&queue)) own->enable();
}

}  // namespace

/// The node beside the camera's driver in one process: a cloud arrives without being copied.
/// Parameters that are unfit to drive with keep it from loading.
class SafetyControlNodelet : public nodelet::Nodelet {
  void onInit() override {
    open(getSTCallbackQueue());
    open(getMTCallbackQueue());
    node_ = node_of(getNodeHandle(), getPrivateNodeHandle(), Delivery::Shared);
    last_word_ = std::make_unique<LastWord>([this] { node_->end(); });
  }

  std::unique_ptr<Node> node_;
  std::unique_ptr<LastWord> last_word_;  ///< of the node: goes before it
};

}  // namespace safety_control_cloud

PLUGINLIB_EXPORT_CLASS(safety_control_cloud::SafetyControlNodelet, nodelet::Nodelet)
