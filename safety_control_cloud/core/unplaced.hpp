// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "doubt/doubt.hpp"
#include "sensor.hpp"
#include "settings.hpp"

namespace safety_control_cloud {

/// What another process wrote of things near or lost, and nobody in this one can go on with: the sensor that saw them
/// is not there, or it is written in another way. Nobody knows where they are: the robot stands until somebody has
/// looked.
class Unplaced {
 public:
  static constexpr const char* hint = "~reset is called, after somebody has looked";

  /// A text that is not empty.
  void note(const std::string& text);
  void forget() { *this = Unplaced{}; }

  /// Drops what whoever wrote it would not have gone on with by now either: by near_loss_timeout, since this was asked
  /// first, and by memory_time what was placed by odometry.
  void forget_old(const Instant& now, const Settings& settings);

  bool any() const { return !texts_.empty(); }
  std::optional<Doubt> doubt() const;
  std::optional<double> since() const { return since_; }  ///< [s] steady

  /// As they were written, for another process to go on with.
  std::vector<std::string> texts() const;

 private:
  struct Text {
    std::string text;
    std::optional<double> placed_at;  ///< [s, ROS time] by odometry
  };

  std::vector<Text> texts_;
  std::optional<double> since_;
};

}  // namespace safety_control_cloud
