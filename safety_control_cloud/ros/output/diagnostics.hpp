// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>
#include <std_msgs/Header.h>

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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
  using Say = std::function<void(const std::string&)>;

  /// `warn` is told why nothing is reported. `sensors`: their names, if there are several.
  Diagnostics(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle, Say warn,
              const std::vector<std::string>& sensors = {""});

  /// A cloud of one of the sensors was decided on in `decision_time` [s]; `latency` [s] is the time from its stamp to
  /// the decision.
  void on_cloud(const Decision& decision, const std_msgs::Header& cloud, double decision_time, double latency,
                std::size_t sensor = 0);
  void on_quiet(const Decision& decision);

  /// For so long [s] commands pass whatever is seen; 0: no.
  void note_override(double left) { override_left_ = left; }

 private:
  /// How one sensor feeds the node.
  struct Fed {
    std::string name;
    Durations periods = {};
    std::optional<ros::SteadyTime> last_arrival = std::nullopt;
    std::optional<std::uint32_t> last_seq = std::nullopt;
    std::size_t dropped = 0;

    void note(const std_msgs::Header& cloud);
    void add_to(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  };

  void update();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  diagnostic_updater::Updater updater_;
  const Say warn_;
  bool is_period_bad_ = false;
  ros::SteadyTime updated_;
  Decision decision_;
  double override_left_ = 0.0;
  std::vector<Fed> fed_;
  Durations decision_times_, latencies_;
};

}  // namespace safety_control_cloud
