// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/server.h>
#include <ros/node_handle.h>
#include <safety_control_cloud/SafetyControlConfig.h>

#include <functional>

#include "../core/settings.hpp"
#include "output/log.hpp"

namespace safety_control_cloud {

/// The numbers of the settings, live over dynamic_reconfigure. A candidate is checked as a whole and taken whole or not
/// at all; if not, the caller gets the settings that stay in force, and the reasons in `refusal`. What is fit but
/// unwise is said at start, when the server hands over its first candidate, and at every change.
class Reconfigure {
 public:
  /// Goes on with other settings, or throws std::invalid_argument and keeps the old ones.
  using Adopt = std::function<void(const Settings&)>;

  Reconfigure(const ros::NodeHandle& private_handle, const Settings& settings, Adopt adopt, Log& log);

 private:
  void on_candidate(SafetyControlConfig& candidate);

  Settings settings_;  ///< in force
  const Adopt adopt_;
  Log& log_;
  /// As it was given: a float32 limit read back would show as -0.30000001192.
  SafetyControlConfig in_force_ = SafetyControlConfig::__getDefault__();
  dynamic_reconfigure::Server<SafetyControlConfig> server_;
};

}  // namespace safety_control_cloud
