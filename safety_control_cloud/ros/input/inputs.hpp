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

/// What a sensor sends, from its topic; if it names none, from the tutorial's for its type.
std::unique_ptr<Input> input_of(const SensorSettings& sensor, ros::NodeHandle& handle,
                                const ros::NodeHandle& private_handle, Delivery delivery, const OnArrival& on_arrival,
                                const Warn& warn);

/// The topics that it hears, by their resolved names.
std::vector<Wanted> wanted_by(const SensorSettings& sensor, const ros::NodeHandle& handle,
                              const ros::NodeHandle& private_handle);

}  // namespace safety_control_cloud
