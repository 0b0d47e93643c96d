// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pixels.hpp"

namespace safety_control_cloud {

/// Which rows and columns at the sides of a picture never return: most cameras leave some of it empty, at most an
/// eighth on each side. A hole there says nothing. What has returned in a good part of some successive pictures is no
/// margin any more, whatever hides it; and before enough of them have come, nothing is one.
class Margins {
 public:
  /// Looks at one pixel of each line of which it is not known yet; the framing by now.
  Framing note(const Pixels& picture);

 private:
  /// The lines at one side, from the outermost in.
  struct Side {
    std::size_t empty = 0;               ///< so many have not been seen to return
    std::vector<std::uint8_t> returned;  ///< of each of them, in how many of the latest pictures
  };
  enum { Left, Top, Right, Bottom };

  std::size_t width_ = 0, height_ = 0;
  std::size_t pictures_ = 0;
  std::array<Side, 4> sides_;
};

}  // namespace safety_control_cloud
