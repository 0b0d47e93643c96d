// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "known.hpp"
#include "settings.hpp"

namespace safety_control_cloud {

/// What somebody asks for who sees more than the sensor.
struct OverrideWish {
  double seconds = 0.0;        ///< [s] for so long; 0 ends it
  double speed = 0.0;          ///< [m/s] of the footprint's fastest point
  bool even_in_doubt = false;  ///< also while the sensor is not to be believed
};

struct OverrideReply {
  bool granted;
  std::string words;  ///< why not, or what holds now
};

/// What a sensor shows, or does not show, is not asked for a while. Ends by itself; times are steady [s].
class SightOverride {
 public:
  /// `doubt`: what speaks against the sensor now. Refused, an earlier one holds on.
  OverrideReply ask(const OverrideWish& wish, const GuardSettings& settings, const std::optional<Doubt>& doubt,
                    double now);

  /// Goes on under other settings: slower, or not at all if they would not have granted it.
  void adopt(const GuardSettings& settings);

  bool holds(double now) const { return left(now) > 0.0; }
  double left(double now) const;           ///< [s]; 0 if it does not hold
  double speed() const { return speed_; }  ///< [m/s] of the fastest point

  /// Whether a command may pass for it: that there are two commanders is no matter of sight, and so no matter of this.
  bool covers(const std::vector<Known>& known, double now) const;

 private:
  void end() { until_.reset(); }

  std::optional<double> until_;
  OverrideWish granted_;
  double speed_ = 0.0;
};

/// Why a sensor is not to be believed, wherever it looks. What is too close to measure was seen.
std::optional<Doubt> doubt_of(const Known& known);
std::optional<Doubt> doubt_of(const std::vector<Known>& known);  ///< of the first for which there is one

}  // namespace safety_control_cloud
