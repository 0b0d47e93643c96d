// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "guard/contradiction.hpp"
#include "guard/given.hpp"
#include "guard/odometry.hpp"
#include "sensor.hpp"

namespace safety_control_cloud {

/// Whether odometry contradicts what the base was told: a child frame that is turned, a sign that is wrong. Then all
/// that is placed by it lies elsewhere, for `time` [s].
class OdometryCheck {
 public:
  explicit OdometryCheck(double time) : time_(time) {}

  /// Goes on with another time.
  void keep_for(double time) { time_ = time; }

  void forget();

  /// A sensor has looked, and this is how the look is placed; null: not by odometry. Whether that could be compared.
  bool note_look(const Odometry* odometry, const Given& given, const Instant& now);

  /// Odometry jumps, after it stood though the base was told to go: then it was wrong all the time, and so is what was
  /// placed by it. Whether that is so.
  bool note_jump(const Instant& now);

  bool has_contradicted() const { return contradicted_.has_value(); }

  /// Something was near since it did. By such odometry no two looks show a thing at the same place, and the next ones
  /// see it gone: nothing need be kept by now.
  void note_that_something_was_near() { contradicted_->misplaces = true; }

  /// In words, how it contradicts, if anything was near since; none: it does not, or did longer ago. `now` [s, steady].
  std::optional<std::string> contradiction_at(double now) const;

 private:
  struct Contradicted {
    double at;        ///< [s, steady] for the last time
    bool misplaces;   ///< anything was near since
    std::string how;  ///< in words
  };

  void contradict(std::string how, double now);

  double time_;
  Contradictions all_;
  std::optional<Contradicted> contradicted_;
  std::deque<Instant> looked_;  ///< lately
};

}  // namespace safety_control_cloud
