// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "../../core/doubt/doubt.hpp"
#include "../../core/sensor.hpp"
#include "../../core/settings.hpp"

namespace safety_control_cloud {

/// Knows when this process stood still as a whole (Ctrl-Z, a debugger, a machine that slept). What it finds waiting in
/// its sockets when it goes on was sent before or meanwhile.
class OwnGap {
 public:
  /// The process runs: called often, also where nothing arrives. A node that runs does something in the longer of
  /// source_timeout and two periods of publish_rate; a gap is longer. To what somebody asks of it, a shorter one is one
  /// too: longer than command_timeout.
  ///
  /// [s] Such a gap that has just ended, be it of one kind or the other.
  std::optional<double> beat(const Instant& now, const Settings& settings);

  /// Of a cloud with this stamp [s] that is taken now: a doubt if it is from before the process went on. For as long
  /// as the limit after that: later the stamps are of another clock. None where no stamp is to be believed.
  std::optional<Doubt> doubt_about(double stamp, const Instant& now, const Settings& settings) const;

  /// Whether the process went on less than so many [s] ago, so that what was asked of it may have waited.
  bool has_gone_on_within(double seconds, const Instant& now) const;

 private:
  std::optional<double> last_;  ///< [s] steady
  double gap_ = 0.0;            ///< [s]
  std::optional<Instant> went_on_;
  std::optional<double> hears_since_;  ///< [s] steady
};

}  // namespace safety_control_cloud
