// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace safety_control_cloud {

/// By how much a camera that may go up and down on a mast was higher in one of the latest pictures, as TF has it. Who
/// knows the floor as so far below the camera may be wrong by as much: if TF was off as he learned that, or is now. He
/// who looks for the floor too low stands; too high, and he would take what is on the floor for that.
class CameraHeight {
 public:
  /// In the next picture [m]: by so much it was higher [m].
  float note(float height) {
    if (!any_) latest_.fill(height);
    any_ = true;
    latest_[next_] = height;
    next_ = (next_ + 1) % latest_.size();
    return *std::max_element(latest_.begin(), latest_.end()) - height;
  }

 private:
  std::array<float, 10> latest_{};
  std::size_t next_ = 0;
  bool any_ = false;
};

}  // namespace safety_control_cloud
