// SPDX-License-Identifier: BSD-3-Clause
#include "channel.hpp"

namespace safety_control_cloud {
namespace {

std::string first_words(const SensorSettings& sensor) {
  const char* what = sensor.type == InputKind::Depth  ? "Depth image"
                     : sensor.type == InputKind::Scan ? "Scan"
                                                      : "Point cloud";
  return std::string(what) + (sensor.topic.empty() ? " arrived" : " of " + sensor.name + " arrived");
}

}  // namespace

Channel::Channel(const SensorSettings& sensor, const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                 const std::string& own)
    : sensor_(sensor), awaited_(wanted_by(sensor, handle, private_handle), own) {}

void Channel::open(ros::NodeHandle& handle, const ros::NodeHandle& private_handle, Delivery delivery,
                   const OnArrival& on_arrival, const Warn& log, const Warn& warn) {
  const auto take = [this, on_arrival, log](const Arrival& arrival) {
    if (!has_sent_) log(first_words(sensor_));
    has_sent_ = true;
    awaited_.has_come();
    on_arrival(arrival);
  };
  input_ = input_of(sensor_, handle, private_handle, delivery, take, warn);
}

}  // namespace safety_control_cloud
