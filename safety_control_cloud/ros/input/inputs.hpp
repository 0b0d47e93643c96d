// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <vector>

#include "../../core/settings.hpp"
#include "arrival.hpp"
#include "awaited.hpp"
#include "input.hpp"

namespace safety_control_cloud {

/// The input of this kind, on the tutorial's topic for it.
std::unique_ptr<Input> input_of(InputKind kind, ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                                Delivery delivery, const OnArrival& on_arrival, const Warn& warn);

/// The topics that it hears, by their resolved names.
std::vector<Wanted> wanted_by(InputKind kind, const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);

}  // namespace safety_control_cloud
