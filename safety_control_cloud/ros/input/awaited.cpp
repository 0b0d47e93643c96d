// SPDX-License-Identifier: BSD-3-Clause
#include "awaited.hpp"

#include <ros/master.h>
#include <ros/this_node.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "../../core/text/words.hpp"

namespace safety_control_cloud {
namespace {

using XmlRpc::XmlRpcValue;

constexpr double period = 1.0;         ///< [s] after which the master is asked again
constexpr std::size_t most_named = 3;  ///< a line of the log is no list

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most_named); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > most_named ? words(text, " and ", names.size() - most_named, " more") : text;
}

/// Where else there is such a thing.
std::string elsewhere(const Wanted& wanted, const std::vector<Published>& published, const std::string& own) {
  std::vector<std::string> others;
  for (const Published& one : published) {
    if (one.topic != wanted.topic && one.topic != own && one.type == wanted.type) others.push_back(one.topic);
  }
  if (others.empty()) return "";
  return words("; ", wanted.type, " is published on ", joined(others), ": remap to it, if that is meant");
}

const Published* publication_of(const Wanted& wanted, const std::vector<Published>& published) {
  const auto is_it = [&](const Published& one) { return one.topic == wanted.topic && !one.nodes.empty(); };
  const auto found = std::find_if(published.begin(), published.end(), is_it);
  return found == published.end() ? nullptr : &*found;
}

std::optional<XmlRpcValue> asked(const char* what) {
  XmlRpcValue request, response, answer;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute(what, request, response, answer, false)) return std::nullopt;
  return answer;
}

std::optional<std::vector<Published>> all_published() {
  auto types = asked("getTopicTypes"), state = asked("getSystemState");
  if (!types || !state) return std::nullopt;
  std::map<std::string, std::string> type_of;
  for (int i = 0; i < types->size(); ++i) type_of[(*types)[i][0]] = static_cast<std::string>((*types)[i][1]);
  std::vector<Published> all;
  XmlRpcValue& published = (*state)[0];
  for (int i = 0; i < published.size(); ++i) {
    const std::string topic = published[i][0];
    all.push_back({topic, type_of[topic], {}});
    for (int j = 0; j < published[i][1].size(); ++j) all.back().nodes.push_back(published[i][1][j]);
  }
  return all;
}

}  // namespace

std::string why_nothing_came(const std::vector<Wanted>& wanted, const std::vector<Published>& published,
                             const std::string& own) {
  for (const Wanted& one : wanted) {
    const Published* found = publication_of(one, published);
    if (!found) return words("nobody publishes ", one.topic, elsewhere(one, published, own));
    if (found->type != one.type) {
      return words(joined(found->nodes), " publishes ", one.topic, " as ", found->type, ", not as ", one.type,
                   elsewhere(one, published, own));
    }
  }
  const auto& nodes = publication_of(wanted.front(), published)->nodes;
  return words(wanted.front().topic, " has ", nodes.size(), nodes.size() == 1 ? " publisher, " : " publishers, ",
               joined(nodes), ", and nothing has come from there");
}

Awaited::Awaited(std::vector<Wanted> wanted, std::string own)
    : wanted_(std::move(wanted)),
      own_(std::move(own)),
      why_("on " + wanted_.front().topic),
      thread_([this] { ask(); }) {}

Awaited::~Awaited() {
  has_come();
  thread_.join();
}

std::string Awaited::why() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return why_;
}

void Awaited::has_come() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (ending_) return;
    ending_ = true;
  }
  came_.notify_all();
}

void Awaited::ask() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ending_) {
    lock.unlock();
    const auto published = all_published();
    std::string why = published ? why_nothing_came(wanted_, *published, own_) : "the ROS master does not answer";
    lock.lock();
    why_ = std::move(why);
    if (!ending_) came_.wait_for(lock, for_seconds(period));
  }
}

}  // namespace safety_control_cloud
