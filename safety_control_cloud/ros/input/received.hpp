// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>
#include <ros/ros.h>
#include <ros/serialization.h>

#include <functional>
#include <string>

#include "source.hpp"

namespace safety_control_cloud {

/// Takes a serialised message and who sent it, as source_of() has it. Both are borrowed for the length of the call.
using Take = std::function<void(ros::serialization::IStream& message, const std::string& source)>;

/// A Message to roscpp, but one that keeps nothing: it is taken while it is being deserialised, the only moment at
/// which roscpp shows a subscriber the buffer that it received.
template <class Message>
struct Received {
  Take take;
  std::string source = {};
};

/// Only the latest message waits to be taken, in the handle's own queue if there is no other.
template <class Message>
ros::Subscriber subscribe_received(ros::NodeHandle& handle, const std::string& topic, const Take& take,
                                   ros::CallbackQueueInterface* queue = nullptr) {
  using Pointer = boost::shared_ptr<const Received<Message>>;
  const auto done_while_read = [](const Pointer&) {};
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const Pointer&>(
      topic, 1, done_while_read, [take] { return boost::make_shared<Received<Message>>(Received<Message>{take}); });
  options.callback_queue = queue;
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  return handle.subscribe(options);
}

}  // namespace safety_control_cloud

namespace ros {
namespace message_traits {

template <class Message>
struct MD5Sum<safety_control_cloud::Received<Message>> : MD5Sum<Message> {};
template <class Message>
struct DataType<safety_control_cloud::Received<Message>> : DataType<Message> {};

}  // namespace message_traits

namespace serialization {

template <class Message>
struct PreDeserialize<safety_control_cloud::Received<Message>> {
  static void notify(const PreDeserializeParams<safety_control_cloud::Received<Message>>& about) {
    about.message->source = safety_control_cloud::source_of(about.connection_header);
  }
};

template <class Message>
struct Serializer<safety_control_cloud::Received<Message>> {
  static void read(IStream& stream, safety_control_cloud::Received<Message>& received) {
    received.take(stream, received.source);
  }
};

}  // namespace serialization
}  // namespace ros
