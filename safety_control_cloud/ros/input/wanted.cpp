// SPDX-License-Identifier: BSD-3-Clause
#include "wanted.hpp"

#include <geometry_msgs/TwistStamped.h>
#include <ros/message_event.h>

#include <algorithm>
#include <boost/weak_ptr.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "../graph/named_in.hpp"

namespace safety_control_cloud {
namespace {

template <class Message>
using Event = ros::MessageEvent<Message const>;

template <class Message>
ros::Subscriber subscribe(ros::NodeHandle& handle, std::function<void(const Event<Message>&)> on_event) {
  return handle.subscribe<Message>(named_in(handle, "cmd_vel_in"), 1,
                                   boost::function<void(const Event<Message>&)>(std::move(on_event)), nullptr,
                                   ros::TransportHints().tcpNoDelay());
}

/// The connections of latching publishers over which something was heard.
class Heard {
 public:
  /// Whether this may be what its publisher said last before it was connected.
  bool may_be_latched(const Event<geometry_msgs::Twist>& event) {
    const auto& connection = event.getConnectionHeaderPtr();
    if (!connection) return false;
    const auto latching = connection->find("latching");
    if (latching == connection->end() || latching->second != "1") return false;
    const auto is_over = [](const Connection& one) { return one.expired(); };
    heard_.erase(std::remove_if(heard_.begin(), heard_.end(), is_over), heard_.end());
    const auto is_this = [&](const Connection& one) { return one.lock() == connection; };
    const bool is_first = std::none_of(heard_.begin(), heard_.end(), is_this);
    if (is_first) heard_.push_back(connection);
    return is_first;
  }

 private:
  using Connection = boost::weak_ptr<ros::M_string>;  ///< by its header

  std::vector<Connection> heard_;
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
