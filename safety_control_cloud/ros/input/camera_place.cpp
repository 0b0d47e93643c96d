// SPDX-License-Identifier: BSD-3-Clause
#include "camera_place.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "../../core/text/words.hpp"

namespace safety_control_cloud {
namespace {

/// [s] by which the newest transform may be older than a cloud: frames that move are published a little late.
constexpr double transform_tolerance = 0.1;

/// By which a frame may have moved in as long before: by as much the newest transform is off, or it rests.
constexpr double most_turned = 0.02, most_moved = 0.01;  ///< [rad], [m]

Eigen::Quaterniond rotation_of(const geometry_msgs::Transform& transform) {
  const auto& rotation = transform.rotation;
  return {rotation.w, rotation.x, rotation.y, rotation.z};
}

Eigen::Vector3d translation_of(const geometry_msgs::Transform& transform) {
  return {transform.translation.x, transform.translation.y, transform.translation.z};
}

/// Written so that NaN has moved.
bool has_moved(const geometry_msgs::Transform& before, const geometry_msgs::Transform& now) {
  return !(rotation_of(before).angularDistance(rotation_of(now)) <= most_turned &&
           (translation_of(now) - translation_of(before)).norm() <= most_moved);
}

geometry_msgs::TransformStamped lookup(const tf2_ros::Buffer& buffer, const std::string& target_frame,
                                       const std_msgs::Header& cloud) {
  try {
    return buffer.lookupTransform(target_frame, cloud.frame_id, cloud.stamp);
  } catch (const tf2::ExtrapolationException&) {
    const auto newest = buffer.lookupTransform(target_frame, cloud.frame_id, ros::Time(0));
    const double late = cloud.stamp.toSec() - newest.header.stamp.toSec();
    if (!(late >= 0.0 && late <= transform_tolerance)) throw;
    const ros::Time as_long_before = newest.header.stamp - ros::Duration(late);
    const auto before = buffer.lookupTransform(target_frame, cloud.frame_id, as_long_before);
    if (has_moved(before.transform, newest.transform))
      throw std::runtime_error(words(cloud.frame_id, " moves in ", target_frame, ", and its newest transform is ",
                                     measured(late, "s"), " older than the cloud"));
    return newest;
  }
}

Placing to_placing(const geometry_msgs::Transform& cloud_in_target) {
  const Eigen::Quaterniond turn = rotation_of(cloud_in_target);
  if (!(std::abs(turn.norm() - 1.0) < 1e-3)) return NoTransform{"the transform's rotation is not a unit quaternion"};
  Eigen::Matrix<double, 3, 4> to_target;
  to_target << turn.normalized().toRotationMatrix(), translation_of(cloud_in_target);
  return placing_of(to_target);
}

ros::NodeHandle handle_on(ros::CallbackQueue& queue) {
  ros::NodeHandle handle;
  handle.setCallbackQueue(&queue);
  return handle;
}

}  // namespace

/// The listener's own thread would wake a hundred times a second, even where nobody sends a transform.
CameraPlace::CameraPlace(const std::string& target_frame, Say warn)
    : target_frame_(target_frame),
      handle_(handle_on(heard_)),
      listener_(buffer_, handle_, false),
      warn_(std::move(warn)),
      hearing_(heard_, [this](const std::exception& problem) {
        on_thrown(problem.what());
        return true;
      }) {
  buffer_.setUsingDedicatedThread(true);  // which this is
}

/// By ros::Time, of a stamp at the end of its range. Each problem is told once: they may come a hundred times a second.
void CameraPlace::on_thrown(const std::string& problem) {
  if (problem == std::exchange(told_, problem)) return;
  warn_("transforms that have come together cannot be taken: " + problem);
}

Placing CameraPlace::at(const std_msgs::Header& cloud) const {
  try {
    return to_placing(lookup(buffer_, target_frame_, cloud).transform);
  } catch (const std::runtime_error& problem) {  // tf2's own, and ros::Duration's for stamps that it cannot span
    return NoTransform{problem.what()};
  }
}

}  // namespace safety_control_cloud
