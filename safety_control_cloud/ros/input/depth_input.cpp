// SPDX-License-Identifier: BSD-3-Clause
#include "depth_input.hpp"

#include <image_transport/camera_common.h>

#include <utility>

#include "received.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::uint32_t latest_only = 1;
constexpr std::size_t many = 10;        ///< images alone; a few come before the first CameraInfo
constexpr double warning_period = 5.0;  ///< [s]
constexpr char as_it_is[] = "raw";      ///< image_transport's name for an image that it leaves alone

/// CameraInfo's own definition names the topics so: image_raw from the driver, image_rect once it is rectified. Nothing
/// in the messages themselves tells, as both come with the CameraInfo of the raw one.
bool is_rectified(const std::string& topic) { return topic.find("_rect", topic.rfind('/')) != std::string::npos; }

}  // namespace

DepthInput::DepthInput(ros::NodeHandle& handle, const ros::NodeHandle& private_handle, const std::string& topic,
                       Delivery delivery, OnArrival on_arrival, Warn warn)
    : on_arrival_(std::move(on_arrival)),
      warn_(std::move(warn)),
      topic_(handle.resolveName(topic)),
      pairs_([this](const DepthImage& image, const CameraEvent& camera) { on_pair(image, camera); }),
      after_cameras_(*handle.getCallbackQueue()) {
  const auto at_once = ros::TransportHints().tcpNoDelay();
  cameras_ = handle.subscribe<sensor_msgs::CameraInfo>(
      image_transport::getCameraInfoTopic(topic_), DepthPairs::waiting,
      boost::function<void(const CameraEvent&)>([this](const CameraEvent& camera) { pairs_.add(camera); }), nullptr,
      at_once);
  const image_transport::TransportHints hints(as_it_is, at_once, private_handle);
  const bool in_place = delivery == Delivery::InPlace && hints.getTransport() == as_it_is;
  in_place ? take_in_place(handle, topic) : take_by_transport(handle, topic, hints);
}

/// The CameraInfo often comes in the moment after its image. If it goes first, the image need not be copied.
void DepthInput::take_in_place(ros::NodeHandle& handle, const std::string& topic) {
  const auto take = [this](ros::serialization::IStream& message, const std::string& source) {
    DepthImage image = image_in(message);
    image.source = source;
    on_image(image);
  };
  received_ = subscribe_received<sensor_msgs::Image>(handle, topic, take, &after_cameras_);
}

/// It does not tell who sent.
void DepthInput::take_by_transport(ros::NodeHandle& handle, const std::string& topic,
                                   const image_transport::TransportHints& hints) {
  const auto take = [this](const sensor_msgs::Image::ConstPtr& message) { on_image(image_in(message)); };
  transport_.emplace(handle);
  transported_ = transport_->subscribe(topic, latest_only, take, nullptr, hints);
}

void DepthInput::on_image(const DepthImage& image) {
  if (!image.problem.empty()) return on_arrival_(Arrival{image.header, Unreadable{image.problem}, image.source});
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (++images_alone_ > many && (now - warned_).toSec() > warning_period) {
    warn_("images arrive on " + topic_ + ", and no CameraInfo with their stamps on " + cameras_.getTopic());
    warned_ = now;
  }
  pairs_.add(image);
}

void DepthInput::on_pair(const DepthImage& image, const CameraEvent& camera) {
  images_alone_ = 0;
  const std::string source = image.source.empty() ? source_of(camera.getConnectionHeaderPtr()) : image.source;
  const auto read = [&] { return view_of(image, *camera.getConstMessage(), is_rectified(topic_)); };
  on_arrival_(Arrival{image.header, readable(read), source});
}

}  // namespace safety_control_cloud
