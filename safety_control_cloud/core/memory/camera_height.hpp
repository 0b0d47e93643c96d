// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace safety_control_cloud {

/// How high a camera is that may go up and down on a mast: the highest that TF said in the latest pictures. Who knows
/// the floor as so far below the camera looks for it too low if that is off, and then stands; too high, and he would
/// take what is on the floor for that.
class CameraHeight {
 public:
  /// In the next picture [m]; which counts from then on.
  float note(float height) {
    if (!any_) latest_.fill(height);
    any_ = true;
    latest_[next_] = height;
    next_ = (next_ + 1) % latest_.size();
    return *std::max_element(latest_.begin(), latest_.end());
  }

 private:
  std::array<float, 10> latest_{};
  std::size_t next_ = 0;
  bool any_ = false;
};

}  // namespace safety_control_cloud
