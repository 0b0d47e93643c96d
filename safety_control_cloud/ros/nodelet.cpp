// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "command/last_word.hpp"
#include "nodes.hpp"

namespace safety_control_cloud {

/// The node beside the camera's driver in one process: a cloud arrives without being copied.
/// Parameters that are unfit to drive with keep it from loading.
///
/// It has a queue and a thread of its own. In the manager's a command would wait until two other threads have woken
/// one after the other, and for whatever other nodelets keep them busy with; and nodelet 1.10.0 (Debian 11, Noetic of
/// 2020) keeps its queues shut until onInit returns and throws away what comes meanwhile, so that a timer or a
/// subscription may be dead for good (ros/nodelet_core#106).
class SafetyControlNodelet : public nodelet::Nodelet {
  void onInit() override {
    ros::NodeHandle handle = getNodeHandle(), private_handle = getPrivateNodeHandle();
    handle.setCallbackQueue(&queue_);
    private_handle.setCallbackQueue(&queue_);
    node_ = node_of(handle, private_handle, Delivery::Shared);
    last_word_ = std::make_unique<LastWord>([this] { node_->end(); });
    thread_.start();
  }

  ros::CallbackQueue queue_;
  std::unique_ptr<Node> node_;
  std::unique_ptr<LastWord> last_word_;  ///< of the node: goes before it
  ros::AsyncSpinner thread_{1, &queue_};
};

}  // namespace safety_control_cloud

PLUGINLIB_EXPORT_CLASS(safety_control_cloud::SafetyControlNodelet, nodelet::Nodelet)
