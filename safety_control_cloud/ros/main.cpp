// SPDX-License-Identifier: BSD-3-Clause
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "input/receive_memory.hpp"
#include "nodes.hpp"
#include "parameters.hpp"

namespace {

std::atomic<bool> asked_to_end{false}, another_has_started{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void on_signal(int) { asked_to_end = true; }

/// `rosnode kill`. roscpp's own answer closes the topics at once; the last command must still go out.
void on_shutdown_request(XmlRpc::XmlRpcValue& request, XmlRpc::XmlRpcValue& result) {
  const bool has_reason = request.getType() == XmlRpc::XmlRpcValue::TypeArray && request.size() > 1 &&
                          request[1].getType() == XmlRpc::XmlRpcValue::TypeString;
  const std::string reason = has_reason ? static_cast<std::string>(request[1]) : "";
  another_has_started = reason.find("same name") != std::string::npos;  // as rosmaster says it
  asked_to_end = true;
  result = ros::xmlrpc::responseInt(1, "", 0);
}

void answer_requests_to_end() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  if (std::signal(SIGHUP, on_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // nohup: it outlives its terminal
  ros::XMLRPCManager::instance()->unbind("shutdown");
  ros::XMLRPCManager::instance()->bind("shutdown", on_shutdown_request);
}

/// Runs the node until it is asked to end; leaving the scope publishes the zero command.
void run() {
  using namespace safety_control_cloud;
  const auto node = node_of(ros::NodeHandle(), ros::NodeHandle("~"), Delivery::InPlace);
  while (!asked_to_end && ros::ok()) ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
  if (another_has_started) {
    ROS_FATAL("another node has started as %s, and so this one ends: do two launch files start it? End one of them.",
              ros::this_node::getName().c_str());
  }
}

constexpr const char* usage =
    "Usage: rosrun safety_control_cloud safety_control_node [_PARAMETER:=VALUE]... [TOPIC:=OTHER]...\n\n"
    "Stops a robot before what its depth camera sees, and in doubt. It commands the robot from its start on.\n"
    "Its topics and parameters: safety_control_cloud/README.md and config/README.md, of the package. roslaunch\n"
    "safety_control_cloud safety_control.launch starts it with a file of parameters, and again if it ends.\n";

bool asks_for_help(int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc, [](const std::string& word) { return word == "-h" || word == "--help"; });
}

/// Whether the command line is one to start with; else it says what was meant.
bool is_fit(int argc, char** argv) {
  const auto problems = safety_control_cloud::parameters_without_underscore(argc, argv);
  for (const auto& problem : problems) std::fprintf(stderr, "%s\n", problem.c_str());
  return problems.empty();
}

}  // namespace

int main(int argc, char** argv) {
  if (asks_for_help(argc, argv)) return std::fputs(usage, stdout) < 0 ? EXIT_FAILURE : EXIT_SUCCESS;
  if (!is_fit(argc, argv)) return EXIT_FAILURE;
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
