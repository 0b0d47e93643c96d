// SPDX-License-Identifier: BSD-3-Clause
#include "nodes.hpp"

#include "guard_node.hpp"
#include "parameters.hpp"
#include "safety_node.hpp"

namespace safety_control_cloud {

std::unique_ptr<Node> node_of(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle, Delivery delivery) {
  const Settings settings = load_settings(private_handle);
  if (settings.mode == Mode::Guard) return std::make_unique<GuardNode>(handle, private_handle, delivery, settings);
  return std::make_unique<SafetyNode>(handle, private_handle, delivery, settings);
}

}  // namespace safety_control_cloud
