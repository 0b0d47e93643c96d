// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "../../core/doubt/doubt.hpp"

namespace safety_control_cloud {

/// Knows when this process stood still as a whole (Ctrl-Z, a debugger, a machine that slept). What it finds waiting in
/// its sockets when it goes on was sent before or meanwhile.
class OwnGap {
 public:
  /// The process runs: called often, also where nothing arrives. A gap is longer than `limit` [s].
  void beat(double steady, double ros, double limit);

  /// Of a cloud with this stamp [s] that is taken now: a doubt if it is from before the process went on. For `limit`
  /// [s] after that: later the stamps are of another clock.
  std::optional<Doubt> doubt_about(double stamp, double steady, double limit) const;

 private:
  std::optional<double> last_;  ///< [s] steady
  double gap_ = 0.0;            ///< [s]
  std::optional<double> went_on_;
  double went_on_ros_ = 0.0;
};

}  // namespace safety_control_cloud
