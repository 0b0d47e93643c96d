// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "doubt.hpp"

namespace safety_control_cloud {

/// Follows ROS time, which runs backwards when a recording or a simulation starts anew.
class ClockWatch {
 public:
  /// ROS time is `now` [s]: a doubt if it was later before, but for the small steps by which clocks are set right, and
  /// if it is 0, which is no time: simulated time that nobody publishes, by which every stamp is as old as it should
  /// be.
  std::optional<Doubt> note(double now);

 private:
  std::optional<double> latest_;  ///< [s]
};

}  // namespace safety_control_cloud
