// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>

#include <exception>
#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "command/last_word.hpp"
#include "nodes.hpp"
#include "time/queue_thread.hpp"

namespace safety_control_cloud {

/// The node beside the camera's driver in one process: a cloud arrives without being copied.
/// Parameters that are unfit to drive with keep it from loading.
class SafetyControlNodelet : public nodelet::Nodelet {
  void onInit() override {
    try {
      start();
    } catch (const std::exception& problem) {
      NODELET_FATAL("%s", problem.what());  // the loader tells that it failed, not why
      throw;
    }
  }

  void start() {
    node_ = node_of(on_own_queue(getNodeHandle()), on_own_queue(getPrivateNodeHandle()), Delivery::Shared);
    last_word_ = std::make_unique<LastWord>([this] { node_->end(); });
    decides_ = std::make_unique<QueueThread>(queue_, [this](const std::exception& problem) {
      give_up(problem);
      return false;
    });
  }

  /// As the node does, which then ends; the manager and who else is in it go on.
  void give_up(const std::exception& problem) {
    node_->end();
    NODELET_FATAL("%s; the robot stands until this nodelet is loaded anew", problem.what());
  }

  ros::NodeHandle on_own_queue(ros::NodeHandle handle) {
    handle.setCallbackQueue(&queue_);
    return handle;
  }

  /// Its own, with a thread of its own: other nodelets may keep all of the manager's workers busy, and from the
  /// manager's queue to a worker it is one thread further.
  ros::CallbackQueue queue_;
  std::unique_ptr<Node> node_;
  std::unique_ptr<LastWord> last_word_;   ///< of the node: goes before it
  std::unique_ptr<QueueThread> decides_;  ///< goes first
};

}  // namespace safety_control_cloud

PLUGINLIB_EXPORT_CLASS(safety_control_cloud::SafetyControlNodelet, nodelet::Nodelet)
