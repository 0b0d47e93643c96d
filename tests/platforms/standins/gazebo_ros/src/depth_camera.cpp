// SPDX-License-Identifier: BSD-3-Clause
// Gazebo's depth camera as a Kinect's driver: depth and colour images, and an organised cloud of both.
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gazebo/common/common.hh>
#include <gazebo/rendering/DepthCamera.hh>
#include <gazebo/sensors/DepthCameraSensor.hh>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include "conversions.hpp"
#include "parameters.hpp"
#include "pictures.hpp"

namespace standin {

const std::vector<std::string> KNOWN = {
    "cameraName", "alwaysOn", "updateRate", "imageTopicName", "cameraInfoTopicName", "depthImageTopicName",
    "depthImageCameraInfoTopicName", "pointCloudTopicName", "frameName", "pointCloudCutoff", "pointCloudCutoffMax",
    "useDepth16UC1Format", "hackBaseline", "distortionK1", "distortionK2", "distortionK3", "distortionT1", "distortionT2"};

class DepthCamera : public gazebo::SensorPlugin {
 public:
  void Load(gazebo::sensors::SensorPtr sensor, sdf::ElementPtr plugin) override {
    const Parameters parameters(plugin, KNOWN);
    sensor_ = std::dynamic_pointer_cast<gazebo::sensors::DepthCameraSensor>(sensor);
    if (!sensor_) gzthrow("it belongs into a sensor of type depth");
    camera_ = sensor_->DepthCamera();
    lens_ = {camera_->ImageWidth(), camera_->ImageHeight(), camera_->HFOV().Radian()};
    nearest_ = parameters.value("pointCloudCutoff", 0.4f);
    farthest_ = parameters.value("pointCloudCutoffMax", 5.0f);
    in_millimetres_ = parameters.value("useDepth16UC1Format", false);
    frame_ = parameters.value<std::string>("frameName", "/world");
    advertise(parameters);
    // Of one picture the depth comes first, then the colours.
    on_depth_ = camera_->ConnectNewDepthFrame([this](const float* depth, auto...) { keep(depth); });
    on_image_ = camera_->ConnectNewImageFrame([this](const unsigned char* rgb, auto...) { publish(rgb); });
    sensor_->SetActive(true);
  }

 private:
  void advertise(const Parameters& parameters) {
    node_ = std::make_unique<ros::NodeHandle>("/" + parameters.value<std::string>("cameraName", "camera"));
    const auto topic = [&](const char* parameter, const char* otherwise) {
      return parameters.value<std::string>(parameter, otherwise);
    };
    image_ = node_->advertise<sensor_msgs::Image>(topic("imageTopicName", "image_raw"), 1);
    image_info_ = node_->advertise<sensor_msgs::CameraInfo>(topic("cameraInfoTopicName", "camera_info"), 1);
    depth_ = node_->advertise<sensor_msgs::Image>(topic("depthImageTopicName", "depth/image_raw"), 1);
    depth_info_ = node_->advertise<sensor_msgs::CameraInfo>(topic("depthImageCameraInfoTopicName", "depth/camera_info"), 1);
    cloud_ = node_->advertise<sensor_msgs::PointCloud2>(topic("pointCloudTopicName", "points"), 1);
  }

  void keep(const float* depth) {
    metres_.assign(depth, depth + lens_.width * lens_.height);
    for (float& metre : metres_) {
      if (!(metre > nearest_ && metre < farthest_)) metre = std::numeric_limits<float>::quiet_NaN();
    }
  }

  void publish(const unsigned char* rgb) {
    if (metres_.empty()) return;
    std_msgs::Header header;
    header.stamp = to_ros(sensor_->LastMeasurementTime());
    header.frame_id = frame_;
    const auto info = to_info(header, lens_);
    image_info_.publish(info);
    depth_info_.publish(info);
    if (image_.getNumSubscribers() > 0) image_.publish(to_image(header, lens_, rgb));
    if (depth_.getNumSubscribers() > 0) depth_.publish(to_depth_image(header, lens_, metres_, in_millimetres_));
    if (cloud_.getNumSubscribers() > 0) cloud_.publish(to_cloud(header, lens_, metres_, rgb));
  }

  gazebo::sensors::DepthCameraSensorPtr sensor_;
  gazebo::rendering::DepthCameraPtr camera_;
  Lens lens_;
  float nearest_, farthest_;  // [m]
  bool in_millimetres_;
  std::string frame_;
  std::vector<float> metres_;  // of the last picture; NaN: nothing returned
  std::unique_ptr<ros::NodeHandle> node_;
  ros::Publisher image_, image_info_, depth_, depth_info_, cloud_;
  gazebo::event::ConnectionPtr on_depth_, on_image_;  // last: nothing is called after they are gone
};

GZ_REGISTER_SENSOR_PLUGIN(DepthCamera)

}  // namespace standin
