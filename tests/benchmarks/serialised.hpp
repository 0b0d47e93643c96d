// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <ros/topic_manager.h>

#include <string>

namespace safety_control_cloud {

/// A message with a header, serialised once, so that sending it costs little beside what the receiver does.
class Serialised {
 public:
  template <class Message>
  Serialised(const Message& message, const ros::Publisher& publisher)
      : topic_(publisher.getTopic()), bytes_(ros::serialization::serializeMessage(message)) {}

  /// With this stamp. The bytes before must have arrived: they are the same.
  void publish(const ros::Time& stamp) {
    ros::serialization::OStream stream(bytes_.buf.get() + stamp_offset, sizeof(stamp.sec) + sizeof(stamp.nsec));
    stream.next(stamp.sec);
    stream.next(stamp.nsec);
    ros::SerializedMessage sent;
    ros::TopicManager::instance()->publish(
        topic_, [this] { return bytes_; }, sent);
  }

 private:
  static constexpr std::size_t stamp_offset = 2 * sizeof(std::uint32_t);  // behind the length and header.seq

  std::string topic_;
  ros::SerializedMessage bytes_;
};

}  // namespace safety_control_cloud
