// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <topic_tools/shape_shifter.h>

#include <functional>
#include <optional>
#include <string>

#include "../../core/doubt/doubt.hpp"
#include "../../core/guard/switches.hpp"
#include "../graph/connected.hpp"

namespace safety_control_cloud {

using OnSwitch = std::function<void(const std::string& who, Edge edge, bool touched)>;

/// One switch's way into the node, whatever type its topic has.
class SwitchInput {
 public:
  using OnLiving = std::function<void(const Connected::Living& living)>;

  /// Each word that can be read is handed over, and who lives to say any.
  SwitchInput(ros::NodeHandle& handle, const SwitchSettings& settings, OnSwitch on_switch, OnLiving on_living);
  SwitchInput(const SwitchInput&) = delete;
  SwitchInput& operator=(const SwitchInput&) = delete;

  /// Looks who publishes it. Once all have left or died, it hears any type again, as soon as there is a master: a
  /// subscription keeps to the type of the first.
  void note_publishers();

  /// Why what it said last is not to be believed: nobody publishes it, or its last message cannot be read.
  std::optional<Doubt> doubt() const;

 private:
  void subscribe();
  void on_message(const std::string& who, const topic_tools::ShapeShifter& message);

  const SwitchSettings settings_;
  OnSwitch on_switch_;
  OnLiving on_living_;
  std::optional<Doubt> unreadable_;
  ros::NodeHandle handle_;
  ros::Subscriber subscriber_;
  Connected publishers_;
  bool is_published_ = false, is_left_ = false;
};

}  // namespace safety_control_cloud
