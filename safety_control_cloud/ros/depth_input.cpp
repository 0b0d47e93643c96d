// SPDX-License-Identifier: BSD-3-Clause
#include "depth_input.hpp"

#include <image_transport/camera_common.h>

#include <utility>

#include "messages.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::uint32_t latest_only = 1;
constexpr std::uint32_t waiting = 5;    ///< images or CameraInfos that are held until the other one comes
constexpr std::size_t many = 10;        ///< images alone; a few come before the first CameraInfo
constexpr double warning_period = 5.0;  ///< [s]

/// CameraInfo's own definition names the topics so: image_raw from the driver, image_rect once it is rectified. Nothing
/// in the messages themselves tells, as both come with the CameraInfo of the raw one.
bool is_rectified(const std::string& topic) { return topic.find("_rect", topic.rfind('/')) != std::string::npos; }

}  // namespace

DepthInput::DepthInput(ros::NodeHandle& handle, const ros::NodeHandle& private_handle, const std::string& topic,
                       OnArrival on_arrival)
    : on_arrival_(std::move(on_arrival)), topic_(handle.resolveName(topic)), transport_(handle), pairs_(waiting) {
  const auto hints = ros::TransportHints().tcpNoDelay();
  images_.registerCallback(&DepthInput::on_image, this);
  pairs_.connectInput(images_, cameras_);
  pairs_.registerCallback(&DepthInput::on_pair, this);
  cameras_.subscribe(handle, image_transport::getCameraInfoTopic(topic_), latest_only, hints);
  images_.subscribe(transport_, topic, latest_only, image_transport::TransportHints("raw", hints, private_handle));
}

void DepthInput::on_image(const Image::ConstPtr&) {
  if (++images_alone_ <= many) return;
  ROS_WARN_THROTTLE(warning_period, "images arrive on %s, and no CameraInfo with their stamps on %s", topic_.c_str(),
                    cameras_.getTopic().c_str());
}

void DepthInput::on_pair(const ros::MessageEvent<const Image>& image,
                         const ros::MessageEvent<const CameraInfo>& camera) {
  images_alone_ = 0;
  const Image& depths = *image.getConstMessage();
  const auto read = [&] { return view_of(depths, *camera.getConstMessage(), is_rectified(topic_)); };
  on_arrival_(Arrival{depths.header, readable(read), camera.getPublisherName()});
}

}  // namespace safety_control_cloud
