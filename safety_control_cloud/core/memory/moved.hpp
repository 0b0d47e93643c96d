// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "backdrop.hpp"
#include "thing.hpp"

namespace safety_control_cloud {

/// What hung, and is not where it was lost any more, though there may be a hole of its size in what is seen behind.
struct Moved {
  Spot from;                 ///< as it was seen last
  double size = 0.0;         ///< [m2] of what was lost of it
  unsigned clouds_gone = 0;  ///< so many successive clouds show no such hole

  /// Where it may be by now, as far as it was when it was lost; nowhere if it leaves no hole of its size.
  /// `pixels_each`: of a picture that is `width` pixels wide, for which each of the `hidden` stands.
  std::vector<Spot> spots_in(const std::vector<Backdrop::Place>& hidden, std::size_t pixels_each,
                             std::size_t width) const;
};

/// The nearest of those that were seen to hang: who stands has his place on the floor.
std::optional<Spot> nearest_hanging(const std::vector<Spot>& spots);

/// Of the picture, which is `width` pixels wide: where these lie, and so far around as they may swing before they are
/// seen past.
Backdrop::Part part_around(const std::vector<Spot>& spots, std::size_t width);

}  // namespace safety_control_cloud
