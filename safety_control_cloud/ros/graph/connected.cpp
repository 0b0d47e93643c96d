// SPDX-License-Identifier: BSD-3-Clause
#include "connected.hpp"

#include <ros/master.h>
#include <ros/this_node.h>

#include <utility>

#include "../time/moments.hpp"
#include "living.hpp"

namespace safety_control_cloud {
namespace {

constexpr double period = 1.0;  ///< [s] after which they are asked again

/// The nodes that publish on a topic by the master's books; none if it does not answer.
std::optional<std::vector<std::string>> publishers_of(const std::string& topic) {
  XmlRpc::XmlRpcValue request, response, state;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, state, false)) return std::nullopt;
  std::vector<std::string> names;
  XmlRpc::XmlRpcValue& published = state[0];
  for (int i = 0; i < published.size(); ++i) {
    if (static_cast<std::string>(published[i][0]) != topic) continue;
    for (int j = 0; j < published[i][1].size(); ++j) names.push_back(published[i][1][j]);
  }
  return names;
}

std::optional<std::string> address_of(const std::string& node) {
  XmlRpc::XmlRpcValue request, response, address;
  request[0] = ros::this_node::getName();
  request[1] = node;
  if (!ros::master::execute("lookupNode", request, response, address, false)) return std::nullopt;
  return static_cast<std::string>(address);
}

std::optional<std::vector<std::string>> living_publishers_of(const std::string& topic, Connected::Self self) {
  const auto all = publishers_of(topic);
  if (!all) return std::nullopt;
  std::vector<std::string> living;
  for (const auto& name : *all) {
    if (name == ros::this_node::getName()) {
      if (self == Connected::Self::Counts) living.push_back(name);
      continue;
    }
    const auto address = address_of(name);
    if (!address || may_live(*address)) living.push_back(name);
  }
  return living;
}

}  // namespace

Connected::Connected(std::string topic, Self self)
    : topic_(std::move(topic)), self_(self), thread_([this] { ask(); }) {}

Connected::~Connected() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  asked_.notify_all();
  thread_.join();
}

std::vector<std::string> Connected::names(std::size_t connected) {
  const auto known = living(connected);
  return known ? known->names : std::vector<std::string>{"somebody whose name the ROS master has yet to tell"};
}

std::optional<Connected::Living> Connected::living(std::size_t connected) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (connected != connected_) {
    connected_ = connected;
    answer_.reset();
    asked_.notify_all();
  }
  if (connected == 0) return Living{{}, now().steady};
  return answer_;
}

void Connected::ask() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ending_) {
    if (connected_ == 0 || answer_) asked_.wait_for(lock, for_seconds(period));
    if (ending_ || connected_ == 0) continue;
    const std::size_t connected = connected_;
    lock.unlock();
    const double as_of = now().steady;
    auto names = living_publishers_of(topic_, self_);
    lock.lock();
    if (names && connected == connected_) answer_ = Living{std::move(*names), as_of};
    if (!names) asked_.wait_for(lock, for_seconds(period));
  }
}

}  // namespace safety_control_cloud
