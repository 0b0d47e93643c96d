// SPDX-License-Identifier: BSD-3-Clause
#include "connected.hpp"

#include <ros/master.h>
#include <ros/this_node.h>

#include <algorithm>
#include <map>
#include <utility>

#include "../time/moments.hpp"
#include "living.hpp"

namespace safety_control_cloud {
namespace {

constexpr double period = 1.0;  ///< [s] after which they are asked again

using Nodes = std::vector<std::string>;

bool is_among(const Nodes& nodes, const std::string& name) {
  return std::find(nodes.begin(), nodes.end(), name) != nodes.end();
}

/// Of whom getSystemState has in one of its lists for a topic.
Nodes listed_for(const std::string& topic, XmlRpc::XmlRpcValue& list) {
  Nodes nodes;
  for (int i = 0; i < list.size(); ++i) {
    if (static_cast<std::string>(list[i][0]) != topic) continue;
    for (int j = 0; j < list[i][1].size(); ++j) nodes.push_back(list[i][1][j]);
  }
  return nodes;
}

/// What the master's books say of a topic.
struct Books {
  Nodes publishers;
  bool know_this_node;
};

/// None: it does not answer.
std::optional<Books> books_on(const std::string& topic) {
  XmlRpc::XmlRpcValue request, response, state;
  const std::string self = ros::this_node::getName();
  request[0] = self;
  if (!ros::master::execute("getSystemState", request, response, state, false)) return std::nullopt;
  const Nodes publishers = listed_for(topic, state[0]);
  return Books{publishers, is_among(publishers, self) || is_among(listed_for(topic, state[1]), self)};
}

std::optional<std::string> address_of(const std::string& node) {
  XmlRpc::XmlRpcValue request, response, address;
  request[0] = ros::this_node::getName();
  request[1] = node;
  if (!ros::master::execute("lookupNode", request, response, address, false)) return std::nullopt;
  return static_cast<std::string>(address);
}

using Addresses = std::map<std::string, std::optional<std::string>>;  ///< by node; none: the master did not tell

Addresses addresses_of(const Nodes& nodes, const Addresses& before) {
  Addresses addresses;
  for (const std::string& node : nodes) {
    const auto known = before.find(node);
    auto address = address_of(node);
    addresses[node] = address || known == before.end() ? std::move(address) : known->second;
  }
  return addresses;
}

Nodes living_of(const Addresses& addresses, Connected::Self self) {
  Nodes nodes;
  for (const auto& [node, address] : addresses) {
    const bool is_self = node == ros::this_node::getName();
    if (is_self ? self == Connected::Self::Counts : !address || may_live(*address)) nodes.push_back(node);
  }
  return nodes;
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
  const auto known = living_of_those(connected > 0 ? std::optional(connected) : std::nullopt);
  if (connected == 0) return {};
  return known ? known->names : std::vector<std::string>{"somebody whose name the ROS master has yet to tell"};
}

std::optional<Connected::Living> Connected::living(std::size_t connected) { return living_of_those(connected); }

std::optional<Connected::Living> Connected::living_of_those(std::optional<std::size_t> connected) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (connected_ != connected) {
    connected_ = connected;
    answer_.reset();
    asked_.notify_all();
  }
  return answer_;
}

void Connected::ask() {
  std::optional<Addresses> known;
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ending_) {
    if (!connected_ || answer_) asked_.wait_for(lock, for_seconds(period));
    if (ending_ || !connected_) continue;
    const auto connected = connected_;
    lock.unlock();
    const double as_of = now().steady;
    const auto books = books_on(topic_);
    if (books && books->know_this_node) known = addresses_of(books->publishers, known.value_or(Addresses{}));
    auto names = known ? std::optional(living_of(*known, self_)) : std::nullopt;
    lock.lock();
    if (names && connected == connected_) answer_ = Living{std::move(*names), as_of, books.has_value()};
    if (!names) asked_.wait_for(lock, for_seconds(period));
  }
}

}  // namespace safety_control_cloud
