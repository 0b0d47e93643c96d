// SPDX-License-Identifier: BSD-3-Clause
#include "wanted.hpp"

#include <geometry_msgs/TwistStamped.h>
#include <ros/message_event.h>

#include <boost/weak_ptr.hpp>
#include <map>
#include <memory>
#include <utility>

namespace safety_control_cloud {
namespace {

template <class Message>
using Event = ros::MessageEvent<Message const>;

template <class Message>
ros::Subscriber subscribe(ros::NodeHandle& handle, std::function<void(const Event<Message>&)> on_event) {
  return handle.subscribe<Message>("cmd_vel_in", 1, boost::function<void(const Event<Message>&)>(std::move(on_event)),
                                   nullptr, ros::TransportHints().tcpNoDelay());
}

/// Who is connected, and was heard over that connection.
class Heard {
 public:
  /// Whether this may be what its publisher said last before it was connected.
  bool may_be_latched(const Event<geometry_msgs::Twist>& event) {
    const auto& connection = event.getConnectionHeaderPtr();
    if (!connection) return false;
    const auto latching = connection->find("latching");
    if (latching == connection->end() || latching->second != "1") return false;
    auto& heard = heard_[event.getPublisherName()];
    const bool is_first = heard.lock() != connection;
    heard = connection;
    return is_first;
  }

 private:
  std::map<std::string, boost::weak_ptr<ros::M_string>> heard_;  ///< over which connection, by who it is
};

}  // namespace

ros::Subscriber subscribe_to_wanted(ros::NodeHandle& handle, CommandType type, OnWanted on_wanted,
                                    OnUntimely on_untimely) {
  if (type == CommandType::TwistStamped)
    return subscribe<geometry_msgs::TwistStamped>(handle, [on_wanted](const Event<geometry_msgs::TwistStamped>& event) {
      const geometry_msgs::TwistStamped& wanted = *event.getConstMessage();
      on_wanted(wanted.twist, wanted.header.stamp.toSec());
    });
  const auto heard = std::make_shared<Heard>();
  return subscribe<geometry_msgs::Twist>(handle, [=](const Event<geometry_msgs::Twist>& event) {
    if (heard->may_be_latched(event)) return on_untimely(event.getPublisherName());
    on_wanted(*event.getConstMessage(), std::nullopt);
  });
}

}  // namespace safety_control_cloud
