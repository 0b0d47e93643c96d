// SPDX-License-Identifier: BSD-3-Clause
#include "nodes.hpp"

#include <map>
#include <stdexcept>
#include <string>

#include "graph/named_in.hpp"
#include "guard_node.hpp"
#include "parameters.hpp"
#include "safety_node.hpp"

namespace safety_control_cloud {
namespace {

/// A guard would take its own answers for what is wanted, as fast as it can answer.
void refuse_to_hear_oneself(const ros::NodeHandle& handle) {
  const std::string wanted = handle.resolveName(named_in(handle, "cmd_vel_in"));
  if (wanted != handle.resolveName(named_in(handle, "cmd_vel"))) return;
  throw std::runtime_error("cmd_vel_in and cmd_vel are both " + wanted +
                           ": remap one of them, so that the commands come to the base through this node alone");
}

/// As they are spelt they differ (core/guard/sensors.cpp). roscpp would hand each message to one of them alone.
void refuse_one_topic_twice(const Sensors& sensors, const ros::NodeHandle& handle) {
  std::map<std::string, std::string> names;  // of sensors, by topic
  for (const SensorSettings& sensor : sensors) {
    const std::string topic = handle.resolveName(named_in(handle, sensor.topic));
    const auto [other, is_new] = names.emplace(topic, sensor.name);
    if (!is_new)
      throw std::runtime_error("sensors: " + other->second + " and " + sensor.name + " have the same topic, " + topic +
                               ": leave one of them out, or remap it");
  }
}

}  // namespace

std::unique_ptr<Node> node_of(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle, Delivery delivery) {
  const Settings settings = load_settings(private_handle);
  if (settings.mode != Mode::Guard) return std::make_unique<SafetyNode>(handle, private_handle, delivery, settings);
  refuse_to_hear_oneself(handle);
  refuse_one_topic_twice(settings.sensors, handle);
  return std::make_unique<GuardNode>(handle, private_handle, delivery, settings);
}

}  // namespace safety_control_cloud
