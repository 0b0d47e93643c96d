// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "arrival.hpp"
#include "received.hpp"

namespace safety_control_cloud {

using ReceivedCloud = Received<sensor_msgs::PointCloud2>;

/// The cloud in the bytes of one serialised sensor_msgs/PointCloud2, borrowed from them. Believes no length in them
/// before it has checked it.
Arrival arrival_in(ros::serialization::IStream& stream);

}  // namespace safety_control_cloud
