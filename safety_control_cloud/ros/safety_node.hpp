// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <memory>
#include <optional>
#include <string>

#include "../core/safety_control.hpp"
#include "command/commands.hpp"
#include "input/arrival.hpp"
#include "input/camera_place.hpp"
#include "input/channel.hpp"
#include "input/own_gap.hpp"
#include "memory/lost_things.hpp"
#include "node.hpp"
#include "output/diagnostics.hpp"
#include "output/log.hpp"
#include "output/reports.hpp"
#include "reconfigure.hpp"
#include "time/wake.hpp"

namespace safety_control_cloud {

/// Wires SafetyControl to ROS: every cloud leads to exactly one command, and so does every period without one.
/// Decides nothing itself.
class SafetyNode : public Node {
 public:
  SafetyNode(ros::NodeHandle handle, ros::NodeHandle private_handle, Delivery delivery, const Settings& settings);
  ~SafetyNode() override;
  SafetyNode(const SafetyNode&) = delete;
  SafetyNode& operator=(const SafetyNode&) = delete;

  void end() override { commands_.end(); }

 private:
  void on_arrival(const Arrival& arrival);
  bool may_have_waited(const Instant& came);
  void on_quiet();

  Decision decide(const Arrival& arrival, const Instant& came);
  Placing placing_of(const std_msgs::Header& cloud) const;
  std::optional<Doubt> doubt_without_cloud();
  std::optional<Doubt> doubt_about(const std_msgs::Header& cloud, const Instant& came);
  void publish(const Decision& decision, const Instant& decided);

  Log log_;
  SafetyControl control_;
  Channel camera_;
  Commands commands_;
  std::unique_ptr<CameraPlace> camera_place_;  ///< only with a target frame
  ros::Publisher output_;
  Reports reports_;
  LostThings lost_things_;
  Wake quiet_;
  Reconfigure reconfigure_;
  Diagnostics diagnostics_;
  OwnGap gap_;
  std::optional<double> last_cloud_;  ///< [s] steady
  std_msgs::Header header_;
  Cause said_ = Cause::NoCloud;
};

}  // namespace safety_control_cloud
