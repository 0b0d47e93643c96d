// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <optional>
#include <string>

#include "../core/safety_control.hpp"
#include "command/commands.hpp"
#include "input/arrival.hpp"
#include "input/awaited.hpp"
#include "input/camera_place.hpp"
#include "input/input.hpp"
#include "input/own_gap.hpp"
#include "memory/keepsake.hpp"
#include "node.hpp"
#include "output/diagnostics.hpp"
#include "output/log.hpp"
#include "output/reports.hpp"
#include "reconfigure.hpp"

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
  void on_quiet();
  bool on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& answer);

  Decision decide(const Arrival& arrival);
  Placing placing_of(const std_msgs::Header& cloud) const;
  void beat();
  std::optional<Doubt> doubt_without_cloud();
  std::optional<Doubt> doubt_about(const std_msgs::Header& cloud);
  void publish(const Decision& decision);
  void keep_what_is_near(const Decision& decision);
  void wake_when_quiet();
  double source_timeout_left() const;

  Log log_;
  SafetyControl control_;
  Awaited awaited_;
  Keepsake keepsake_;
  Commands commands_;
  std::unique_ptr<CameraPlace> camera_place_;  ///< only with a target frame
  ros::Publisher output_;
  Reports reports_;
  std::unique_ptr<Input> input_;
  ros::ServiceServer reset_;
  ros::SteadyTimer quiet_;
  Reconfigure reconfigure_;
  Diagnostics diagnostics_;
  OwnGap gap_;
  ros::SteadyTime last_cloud_, last_reset_, last_kept_;
  std_msgs::Header header_;
  Cause said_ = Cause::NoCloud;
};

}  // namespace safety_control_cloud
