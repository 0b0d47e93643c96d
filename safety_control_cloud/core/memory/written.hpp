// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kept.hpp"

namespace safety_control_cloud {

/// What is near or lost, as text that outlives the process; and what another process wrote, until it is taken up, which
/// goes on being written till then.
class Written {
 public:
  /// In some kilobytes; empty if nothing is near or lost.
  const std::string& text() const { return text_; }

  /// Whether anything was near or lost when it was written, or is to be taken up.
  bool is_any_near() const { return is_any_near_ || waits(); }
  bool is_any_lost() const { return is_any_lost_; }

  /// Four times a second, and at once when something is lost or found or nothing is near any more. `kept` tells of all
  /// things; those count that are nearer than `near` [m] ahead of the camera. `now` [s] steady.
  template <class MakeKept>
  void bring_up_to_date(const std::vector<Remembered>& things, float near, bool lost, double now, MakeKept kept) {
    const bool any_near = is_any_near_in(things, near);
    if (!is_due(lost, any_near, now)) return;
    write(kept(), near);
    written_at_ = now;
    is_any_lost_ = lost;
    is_any_near_ = any_near;
  }

  /// From now on it is this that another process wrote; false, and nothing changes, if it makes no sense.
  bool read(const std::string& text);

  /// Whether anything of that waits to be taken up by a camera that looks as it did that lost it.
  bool waits() const { return read_ && (!read_->things.empty() || is_any_low(*read_)); }

  /// What a camera that looks so has to take up now, once; none: nothing.
  std::optional<Kept> taken_up(const Axis& axis);

  /// Nothing waits any more.
  void forget_read() { read_.reset(); }

  /// The corridor, in whose axes it tells that, leads so much farther to the left [rad].
  void turn_corridor(double angle);

 private:
  static bool is_any_near_in(const std::vector<Remembered>& things, float near);
  bool is_due(bool lost, bool any_near, double now) const;
  void write(Kept kept, float near);

  std::string text_;
  std::optional<Kept> read_;
  double written_at_ = 0.0;  ///< [s]
  bool is_any_lost_ = false, is_any_near_ = false;
};

}  // namespace safety_control_cloud
