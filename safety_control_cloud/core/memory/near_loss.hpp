// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "floor_strip.hpp"
#include "kept_nearest.hpp"
#include "loss.hpp"
#include "lost_pixels.hpp"
#include "low_obstacles.hpp"

namespace safety_control_cloud {

struct NearLossLimits {
  double distance = 0.75;  ///< [m] an obstacle seen nearer than this is kept when it stops returning; 0 = off
  double timeout = 0.0;    ///< [s] after which it is forgotten all the same; 0 = never
};

/// Remembers what came near, because a depth camera is blind right before itself (an Xtion nearer than 0.4 m): an
/// obstacle that enters this zone looks like free space far away.
///
/// When a loss is believed and when it is forgiven, safe first and available second:
/// - A pixel that last returned near and returns nothing now still has its obstacle before it; only a return from the
///   same pixel says that it has gone. One noisy pixel is no obstacle: losses count in blocks of 2 x 2.
/// - A hall deeper than the camera's range returns nothing even when free, so somebody who walked past would stop the
///   robot for ever. But who stands on the floor also hides the near floor at the foot of the pixel column; when that
///   floor is seen again, the column is free. What reaches down to the near floor counts too, though it hid none yet:
///   nearer than it was, it would. A board that hangs never hid the floor, so the floor says nothing of it.
/// - Near floor that goes blank over the width of a post is hidden by something too near to return.
/// - What ends below the corridor is lost from sight at the lower edge of the picture: see LowObstacles.
class NearLoss {
 public:
  explicit NearLoss(const NearLossLimits& limits) : limits_(limits) {}

  void limit(const NearLossLimits& limits);
  void forget();

  /// The memory to hand to look() for this cloud; nullptr if it is not organised or the memory is off.
  PixelMemory* memory_for(const View& view);

  /// What of the near obstacles is lost in this cloud, which look() has just seen. `now` [s], steady.
  std::optional<Loss> judge(const View& view, const Sight& sight, const Corridor& corridor, const Gaze& gaze,
                            double now);

 private:
  std::optional<Loss> judge_pixels(const View& view, const Sight& sight, const Gaze& gaze);

  NearLossLimits limits_;
  PixelMemory memory_;
  FloorStrip floor_;
  LostPixels lost_;
  LowObstacles low_;
  KeptNearest nearest_;
  std::optional<double> lost_since_;
};

}  // namespace safety_control_cloud
