// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "doubt.hpp"
#include "settings.hpp"

namespace safety_control_cloud {

/// What was counted in a cloud.
struct Returned {
  std::size_t returns = 0;
  std::size_t total = 0;  ///< points
  bool organised = false;

  /// Whether it says what is missing: a picture with pixels that return nothing.
  bool tells_what_is_missing() const { return organised && returns < total; }
};

/// Few returns are no proof of free space: fewer than `min_returns`, or than `min_valid_ratio` of all points.
std::optional<Doubt> doubt_about_returns(const Returned& cloud, const DoubtSettings& by);

/// Knows how much the sensor showed lately: a cloud whose points are all valid, or that is no picture, does not say how
/// many are missing.
///
/// The level of returns follows slowly (3 s to an e-th of the way, on a logarithmic scale), as a voxel filter thins out
/// a wall that comes nearer. Fewer than min_valid_ratio of it are a doubt. In doubt the level gives in ten times as
/// slowly, so that another filter, or a quick turn from a hall to a wall, does not stop the robot for ever; but never
/// to fewer than min_valid_ratio squared (a hundredth) of the most that it ever was.
class BlindWatch {
 public:
  /// A cloud has come at `now` [s, steady].
  std::optional<Doubt> note(const Returned& cloud, const DoubtSettings& by, double now);

  /// Somebody has looked: what it shows now is what there is.
  void forget() { *this = BlindWatch(); }

 private:
  void follow(double returns, double pace, double now);

  double level_ = 0.0;  ///< returns lately; 0: none yet
  double most_ = 0.0;   ///< that the level ever was
  double last_ = 0.0;   ///< [s] steady: of the latest cloud
};

}  // namespace safety_control_cloud
