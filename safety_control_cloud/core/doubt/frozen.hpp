// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "../input/view.hpp"
#include "doubt.hpp"

namespace safety_control_cloud {

/// Counts successive clouds of the same geometry: a real camera's noise never repeats itself. Colours, and whatever
/// else a point has, may change beside a depth that is frozen.
class FrozenWatch {
 public:
  /// A cloud of this `stamp` [s] has come: a doubt if it is the `most`-th in a row with its geometry, or a later one;
  /// 0 = never, and then no cloud is looked at. A cloud that comes a second time with its stamp was delivered twice and
  /// does not count, a third and later time it does.
  std::optional<Doubt> note(const View& view, double stamp, std::size_t most);

  /// Whether the latest was the one before once more: nothing was looked at anew.
  bool repeats() const { return repeats_; }

 private:
  std::uint64_t content_ = 0;  ///< hash of the latest cloud's points
  double stamp_ = 0.0;
  bool twice_ = false;  ///< the latest stamp has come again
  bool repeats_ = false;
  std::size_t same_ = 0;
};

}  // namespace safety_control_cloud
