// SPDX-License-Identifier: BSD-3-Clause
#include "keepsake.hpp"

#include <ros/master.h>
#include <ros/this_node.h>

#include <utility>

namespace safety_control_cloud {
namespace {

using Texts = Keepsake::Texts;
using XmlRpc::XmlRpcValue;

constexpr double period = 0.5;     ///< [s] after which the master is asked whether it still knows, and then what
constexpr double at_latest = 5.0;  ///< [s] the same while something newer waits, which a slow master is told first

/// Not ros::param's, which waits for the master for ever.
bool ask_master(const char* what, const std::string& name, XmlRpcValue& answer, const XmlRpcValue* value = nullptr) {
  XmlRpcValue request, response;
  request[0] = ros::this_node::getName();
  request[1] = name;
  if (value) request[2] = *value;
  return ros::master::execute(what, request, response, answer, false);
}

/// What is no list of texts, nobody has written who could be asked: one text, which is not understood.
Texts texts_in(XmlRpcValue& value) {
  if (value.getType() != XmlRpcValue::TypeArray) return {value.toXml()};
  Texts texts;
  for (int i = 0; i < value.size(); ++i) {
    if (value[i].getType() != XmlRpcValue::TypeString) return {value.toXml()};
    texts.push_back(value[i]);
  }
  return texts;
}

std::optional<Texts> texts_on_server(const std::string& name) {
  XmlRpcValue value;
  return ask_master("getParam", name, value) ? std::optional(texts_in(value)) : std::nullopt;
}

bool write_to_server(const std::string& name, const Texts& texts) {
  XmlRpcValue value, answer;
  value.setSize(static_cast<int>(texts.size()));
  for (std::size_t i = 0; i < texts.size(); ++i) value[static_cast<int>(i)] = texts[i];
  return ask_master("setParam", name, answer, &value);
}

}  // namespace

Keepsake::Keepsake(const ros::NodeHandle& private_handle, Say say)
    : name_(private_handle.getNamespace() + "_lost/things"),
      say_(std::move(say)),
      found_(texts_on_server(name_)),
      wanted_(found_.value_or(Texts{})),
      thread_([this] { write(); }) {}

Keepsake::~Keepsake() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Keepsake::keep(Texts texts) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (texts == wanted_) return;
    wanted_ = std::move(texts);
  }
  changed_.notify_all();
}

void Keepsake::write() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    const Texts wanted = wanted_;
    const bool last = ending_;
    lock.unlock();
    if (written_ != wanted && write_to_server(name_, wanted)) written_ = wanted;
    if (last) return;
    lock.lock();
    if (wanted_ == wanted || ros::SteadyTime::now() - looked_ > ros::WallDuration(at_latest)) {
      lock.unlock();
      look_whether_it_is_still_there();
      lock.lock();
    }
    if (!ending_ && wanted_ == wanted) changed_.wait_for(lock, for_seconds(period));
  }
}

/// One call at a time, or what is newer waited for two of them. Somebody may have loaded what he dumped an hour ago.
void Keepsake::look_whether_it_is_still_there() {
  looked_ = ros::SteadyTime::now();
  if (!written_) return;
  if (!std::exchange(is_there_, false)) {
    XmlRpcValue is_there;
    const bool is_told = ask_master("hasParam", name_, is_there);
    const bool is_forgotten = is_told && is_there.getType() == XmlRpcValue::TypeBoolean && !is_there;
    is_there_ = is_told && !is_forgotten;
    if (is_forgotten)
      write_anew("the ROS master has forgotten what was near, as one that was started anew does; it is told again");
    return;
  }
  const auto there = texts_on_server(name_);
  if (there && there != written_)
    write_anew("somebody has changed " + name_ + ", which tells what was near; it is written again");
}

void Keepsake::write_anew(const std::string& why) {
  say_(why);
  written_.reset();
}

}  // namespace safety_control_cloud
