// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PolygonStamped.h>
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <safety_control_cloud/Override.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../core/guard_control.hpp"
#include "command/commands.hpp"
#include "input/arrival.hpp"
#include "input/camera_place.hpp"
#include "input/channel.hpp"
#include "input/odometry_input.hpp"
#include "input/own_gap.hpp"
#include "input/switch_input.hpp"
#include "memory/lost_things.hpp"
#include "node.hpp"
#include "output/diagnostics.hpp"
#include "output/guard_reports.hpp"
#include "output/log.hpp"
#include "reconfigure.hpp"
#include "time/wake.hpp"

namespace safety_control_cloud {

/// Wires GuardControl to ROS: each command that comes in leads to one that goes out, and so does each cloud that
/// changes what is safe, and each period without either. Decides nothing itself.
class GuardNode : public Node {
 public:
  GuardNode(ros::NodeHandle handle, ros::NodeHandle private_handle, Delivery delivery, const Settings& settings);
  ~GuardNode() override;
  GuardNode(const GuardNode&) = delete;
  GuardNode& operator=(const GuardNode&) = delete;

  void end() override { commands_.end(); }

 private:
  void on_arrival(std::size_t sensor, const Arrival& arrival);
  void on_wanted(const geometry_msgs::Twist& wanted, std::optional<double> stamp);
  void on_switch(std::size_t which, const std::string& who, Edge edge, bool touched);
  void on_footprint(const geometry_msgs::PolygonStamped& polygon);
  void on_quiet();
  bool on_override(OverrideRequest& wish, OverrideResponse& response);

  void beat(const Instant& now);
  bool may_have_waited(const Instant& came);
  void see(std::size_t sensor, const Arrival& arrival, const Instant& came);
  const Guarded& answer();
  const Guarded& answer_now();
  bool changes(const Guarded& answer) const;
  void publish(const Guarded& answer);

  Log log_;
  GuardControl control_;
  std::vector<std::unique_ptr<Channel>> channels_;      ///< in the order of the control's sensors
  std::vector<std::unique_ptr<SwitchInput>> switches_;  ///< in the order of the settings
  Commands commands_;
  CameraPlace base_;  ///< whose frame the camera is placed in
  GuardReports reports_;
  LostThings lost_things_;
  std::optional<OdometryInput> odometry_;  ///< from the end of the construction on
  ros::Subscriber wanted_, footprint_;
  Wake quiet_;
  ros::ServiceServer override_;
  Reconfigure reconfigure_;
  Diagnostics diagnostics_;
  OwnGap gap_;
  Instant answered_at_;
  std_msgs::Header header_;  ///< of the latest that came
  geometry_msgs::Twist said_;
  Cause said_cause_ = Cause::NoCloud;
};

}  // namespace safety_control_cloud
