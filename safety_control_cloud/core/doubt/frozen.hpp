// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "../input/view.hpp"

namespace safety_control_cloud {

/// Counts successive clouds with new stamps and the same bytes: a real camera's noise never repeats itself.
class FrozenWatch {
 public:
  /// How many clouds in a row, this one included, had the content of this one. `stamp` [s].
  std::size_t count(const View& view, double stamp);

 private:
  std::size_t content_ = 0;  ///< hash of the latest cloud's points
  double stamp_ = 0.0;
  std::size_t same_ = 0;
};

}  // namespace safety_control_cloud
