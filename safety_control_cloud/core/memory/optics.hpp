// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "../look/ray_lines.hpp"
#include "pixels.hpp"

namespace safety_control_cloud {

/// Which way the pixels of a camera's pictures look, from one to the next: a driver may be told to send another part of
/// the picture, or a lens may zoom. A depth image says so itself. The rays of an organised cloud are fitted to its
/// points once, and again when some probes look elsewhere than they did, since a fit takes longer than those.
class Optics {
 public:
  /// Those that are known last, where too little returns to tell.
  const RayLines& look_at(const View& view, const Pixels& picture);

 private:
  static constexpr std::size_t across = 8, down = 6;  ///< probes

  struct Slants {
    float x, y;  ///< over z; NaN where nothing has returned
  };
  using Probes = std::array<Slants, across * down>;

  static Probes probes_of(const Pixels& picture);
  bool look_elsewhere(const Probes& now) const;

  std::size_t width_ = 0, height_ = 0;
  RayLines lines_;
  Probes known_{};  ///< since they were fitted
};

}  // namespace safety_control_cloud
