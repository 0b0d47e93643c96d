// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

namespace safety_control_cloud {

struct Seen {
  float nearest;                  ///< [m] along z; of an empty crop the greatest float, as PCL has it
  sensor_msgs::PointCloud2 crop;  ///< what lies in the corridor
};

/// The tutorial's callback, written plainly: to PCL, PassThrough on y and x, getMinMax3D, and the crop back to ROS.
Seen tutorial(const sensor_msgs::PointCloud2& cloud);

/// The same with lists of indices in place of copies, and no crop to publish: PCL at its best. [m] along z.
float pcl_with_indices(const sensor_msgs::PointCloud2& cloud);

}  // namespace safety_control_cloud
