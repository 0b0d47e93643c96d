// SPDX-License-Identifier: BSD-3-Clause
#include "nodes.hpp"

#include <stdexcept>
#include <string>

#include "graph/named_in.hpp"
#include "guard_node.hpp"
#include "parameters.hpp"
#include "safety_node.hpp"

namespace safety_control_cloud {
namespace {

/// A guard would take its own answers for what is wanted, as fast as it can answer.
void refuse_to_hear_oneself(const ros::NodeHandle& handle) {
  const std::string wanted = handle.resolveName(named_in(handle, "cmd_vel_in"));
  if (wanted != handle.resolveName(named_in(handle, "cmd_vel"))) return;
  throw std::runtime_error("cmd_vel_in and cmd_vel are both " + wanted +
                           ": remap one of them, so that the commands come to the base through this node alone");
}

}  // namespace

std::unique_ptr<Node> node_of(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle, Delivery delivery) {
  const Settings settings = load_settings(private_handle);
  if (settings.mode == Mode::Guard) refuse_to_hear_oneself(handle);
  if (settings.mode == Mode::Guard) return std::make_unique<GuardNode>(handle, private_handle, delivery, settings);
  return std::make_unique<SafetyNode>(handle, private_handle, delivery, settings);
}

}  // namespace safety_control_cloud
