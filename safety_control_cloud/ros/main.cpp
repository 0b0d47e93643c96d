// SPDX-License-Identifier: BSD-3-Clause
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>

#include <atomic>
#include <csignal>
#include <cstdlib>

#include "input/receive_memory.hpp"
#include "parameters.hpp"
#include "safety_node.hpp"

namespace {

std::atomic<bool> asked_to_end{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void on_signal(int) { asked_to_end = true; }

/// `rosnode kill`. roscpp's own answer closes the topics at once; the last command must still go out.
void on_shutdown_request(XmlRpc::XmlRpcValue&, XmlRpc::XmlRpcValue& result) {
  asked_to_end = true;
  result = ros::xmlrpc::responseInt(1, "", 0);
}

void answer_requests_to_end() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  ros::XMLRPCManager::instance()->unbind("shutdown");
  ros::XMLRPCManager::instance()->bind("shutdown", on_shutdown_request);
}

/// Runs the node until it is asked to end; leaving the scope publishes the zero command.
void run() {
  using namespace safety_control_cloud;
  SafetyNode node(ros::NodeHandle(), ros::NodeHandle("~"), Delivery::InPlace);
  while (!asked_to_end && ros::ok()) ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
}

}  // namespace

int main(int argc, char** argv) {
  safety_control_cloud::keep_memory_for_reuse();
  ros::init(argc, argv, "safety_control_cloud", ros::init_options::NoSigintHandler);
  ros::start();
  answer_requests_to_end();
  try {
    run();
  } catch (const std::exception& problem) {
    ROS_FATAL("%s", problem.what());
    return EXIT_FAILURE;
  }
  ros::shutdown();
  return EXIT_SUCCESS;
}
