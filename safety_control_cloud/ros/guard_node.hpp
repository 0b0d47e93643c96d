// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <optional>
#include <string>

#include "../core/guard_control.hpp"
#include "command/commands.hpp"
#include "input/arrival.hpp"
#include "input/camera_place.hpp"
#include "input/input.hpp"
#include "input/own_gap.hpp"
#include "memory/keepsake.hpp"
#include "node.hpp"
#include "output/diagnostics.hpp"
#include "output/guard_reports.hpp"
#include "output/log.hpp"
#include "reconfigure.hpp"

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
  void on_arrival(const Arrival& arrival);
  void on_wanted(const geometry_msgs::Twist& wanted);
  void on_odometry(const nav_msgs::Odometry& odometry);
  void on_quiet();
  bool on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& answer);

  void see(const Arrival& arrival);
  const Guarded& answer();
  void publish(const Guarded& answer);
  void keep_what_is_near(const Guarded& answer);
  void beat();
  std::optional<Doubt> doubt_about(const std_msgs::Header& cloud) const;
  void wake_when_quiet();
  double period() const;

  Log log_;
  GuardControl control_;
  Keepsake keepsake_;
  Commands commands_;
  CameraPlace base_;  ///< whose frame the camera is placed in
  GuardReports reports_;
  std::unique_ptr<Input> input_;
  ros::Subscriber wanted_, odometry_;
  ros::ServiceServer reset_;
  ros::SteadyTimer quiet_;
  Reconfigure reconfigure_;
  Diagnostics diagnostics_;
  OwnGap gap_;
  ros::SteadyTime last_cloud_, last_reset_, last_kept_;
  std_msgs::Header header_;
  std::optional<Doubt> about_cloud_;  ///< the latest, whatever it shows
  geometry_msgs::Twist said_;
  Cause said_cause_ = Cause::NoCloud;
  bool warned_of_frame_ = false;
};

}  // namespace safety_control_cloud
