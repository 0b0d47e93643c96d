// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "known_places.hpp"

namespace safety_control_cloud {

/// Something low before a camera, whose top leaves the picture at its lower border: its front is below that, and may be
/// anywhere up to the robot. Where the robot came to it, the front was seen to rest where it is remembered. Where it
/// came to the robot, nobody knows.
class LookedOver {
 public:
  /// A picture shows that from a camera at `eye`, as far as it shows it at `ends`; `known` is what was seen to rest.
  /// All in base_frame [m]. `now` [s] steady.
  void note(const std::vector<Point2>& ends, const Point2& eye, const std::vector<KnownPlace>& known, double now);

  /// Whether nobody knows how far something reaches that the latest picture shows, or one of the last second.
  bool is_unknown() const { return is_unknown_; }

  /// Somebody has looked.
  void forget() { is_unknown_ = false; }

 private:
  std::optional<double> shown_at_;  ///< [s] steady, last, in pictures that follow each other
  bool is_unknown_ = false;
};

}  // namespace safety_control_cloud
