// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace safety_control_cloud {

/// How long nobody looked between two pictures.
///
/// Their stamps tell when they were taken, also where some waited in a queue meanwhile. A camera that stalls while its
/// stamps go on evenly is found out by when pictures come, from half of source_timeout on: a shorter while is that of a
/// busy computer, and whoever bears a longer silence, as a replay that does not wait, is told by the stamps alone.
class PictureGap {
 public:
  /// [s] since the picture before, at most; of the first, infinite. One with this `stamp` [s] has come at `now` [s,
  /// steady]; stamps that do not go forward tell nothing.
  double note(double stamp, double now, double source_timeout);

 private:
  struct Came {
    double stamp, at;  ///< [s]; steady
  };

  std::optional<Came> last_;
};

}  // namespace safety_control_cloud
