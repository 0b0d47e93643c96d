// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>

#include "input/arrival.hpp"
#include "node.hpp"

namespace safety_control_cloud {

/// The node of the mode that the private parameters name: the one place that asks for it.
/// Throws BadParameters if they are unfit to drive with, runtime_error for a guard that would hear itself.
std::unique_ptr<Node> node_of(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle, Delivery delivery);

}  // namespace safety_control_cloud
