// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

namespace safety_control_cloud {

/// The tutorial's callback, written plainly: to PCL, PassThrough on y and x, getMinMax3D, and the crop back to ROS.
/// [m] along z to the nearest point in the corridor.
float tutorial(const sensor_msgs::PointCloud2& cloud);

/// The same with lists of indices in place of copies, and no crop to publish: PCL at its best.
float pcl_with_indices(const sensor_msgs::PointCloud2& cloud);

}  // namespace safety_control_cloud
