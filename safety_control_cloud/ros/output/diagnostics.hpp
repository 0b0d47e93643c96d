// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>
#include <std_msgs/Header.h>

#include <deque>
#include <optional>

#include "../../core/decision.hpp"

namespace safety_control_cloud {

/// The latest durations, so that their median and tail can be told.
class Durations {
 public:
  void add(double seconds);
  double quantile(double share) const;  ///< [s]; NaN if there are none

 private:
  std::deque<double> latest_;
};

/// Reports on /diagnostics what the node decides and how well it is fed.
class Diagnostics {
 public:
  Diagnostics(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);

  /// A cloud was decided on in `decision_time` [s]; `latency` [s] is the time from its stamp to the decision.
  void on_cloud(const Decision& decision, const std_msgs::Header& cloud, double decision_time, double latency);
  void on_quiet(const Decision& decision);

  /// For so long [s] commands pass whatever is seen; 0: no.
  void note_override(double left) { override_left_ = left; }

 private:
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  diagnostic_updater::Updater updater_;
  Decision decision_;
  double override_left_ = 0.0;
  Durations decision_times_, latencies_, periods_;
  std::optional<ros::SteadyTime> last_arrival_;
  std::optional<std::uint32_t> last_seq_;
  std::size_t dropped_ = 0;
};

}  // namespace safety_control_cloud
