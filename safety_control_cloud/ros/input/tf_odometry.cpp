// SPDX-License-Identifier: BSD-3-Clause
#include "tf_odometry.hpp"

#include "poses.hpp"

namespace safety_control_cloud {

std::optional<TfOdometry::Told> TfOdometry::next(const tf2_ros::Buffer& buffer) {
  geometry_msgs::TransformStamped latest;
  try {
    latest = buffer.lookupTransform(odom_frame_, base_frame_, ros::Time(0));
  } catch (const tf2::TransformException& problem) {
    if (told_.isZero()) why_nothing_ = problem.what();
    return std::nullopt;
  }
  why_nothing_.clear();
  if (latest.header.stamp == told_) return std::nullopt;
  told_ = latest.header.stamp;
  return Told{told_.toSec(), pose_of(latest.transform)};
}

}  // namespace safety_control_cloud
