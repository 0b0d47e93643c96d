// SPDX-License-Identifier: BSD-3-Clause
#include "camera_place.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace safety_control_cloud {
namespace {

/// [s] by which the newest transform may be older than a cloud: frames that move are published a little late.
constexpr double transform_tolerance = 0.1;

geometry_msgs::TransformStamped lookup(const tf2_ros::Buffer& buffer, const std::string& target_frame,
                                       const std_msgs::Header& cloud) {
  try {
    return buffer.lookupTransform(target_frame, cloud.frame_id, cloud.stamp);
  } catch (const tf2::ExtrapolationException&) {
    const auto newest = buffer.lookupTransform(target_frame, cloud.frame_id, ros::Time(0));
    const double late = cloud.stamp.toSec() - newest.header.stamp.toSec();
    if (!(late >= 0.0 && late <= transform_tolerance)) throw;
    return newest;
  }
}

Placing to_placing(const geometry_msgs::Transform& cloud_in_target) {
  const auto& [translation, rotation] = std::tie(cloud_in_target.translation, cloud_in_target.rotation);
  const Eigen::Quaterniond turn(rotation.w, rotation.x, rotation.y, rotation.z);
  if (!(std::abs(turn.norm() - 1.0) < 1e-3)) return NoTransform{"the transform's rotation is not a unit quaternion"};
  Eigen::Matrix<double, 3, 4> to_target;
  to_target << turn.normalized().toRotationMatrix(), Eigen::Vector3d(translation.x, translation.y, translation.z);
  return placing_of(to_target);
}

ros::NodeHandle handle_on(ros::CallbackQueue& queue) {
  ros::NodeHandle handle;
  handle.setCallbackQueue(&queue);
  return handle;
}

}  // namespace

/// The listener's own thread would wake a hundred times a second, even where nobody sends a transform.
CameraPlace::CameraPlace(const std::string& target_frame)
    : target_frame_(target_frame),
      handle_(handle_on(heard_)),
      listener_(buffer_, handle_, false),
      hearing_(1, &heard_) {
  buffer_.setUsingDedicatedThread(true);  // which this is
  hearing_.start();
}

Placing CameraPlace::at(const std_msgs::Header& cloud) const {
  try {
    return to_placing(lookup(buffer_, target_frame_, cloud).transform);
  } catch (const std::runtime_error& problem) {  // tf2's own, and ros::Duration's for stamps that it cannot span
    return NoTransform{problem.what()};
  }
}

}  // namespace safety_control_cloud
