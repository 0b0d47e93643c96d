// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "gaze.hpp"
#include "pixels.hpp"
#include "remembered.hpp"

namespace safety_control_cloud {

/// What is seen past in so many successive clouds has gone.
constexpr unsigned clouds_to_go = 3;

/// What a picture shows of the floor on which things stood.
struct NearFloor {
  /// Whether it is seen again in a column of the picture and nothing is near in it.
  std::function<bool(std::size_t column)> is_seen_again;
  const std::vector<std::size_t>& rows;  ///< of the picture, that show it
  std::uint8_t after = 1;                ///< so many clouds show it before it says anything of what is lost
};

/// Asks a picture about each lost spot of a thing, and drops those that are seen again, that have gone, and that go
/// along with those. What of it counts as gone is added to what is freed.
///
/// - It has gone where the picture shows what is behind it in three successive clouds, or if it stood and the near
///   floor is seen again in its column. If the camera looks elsewhere than when it was seen, it is looked for where the
///   picture shows its place by now (turned.hpp); of what lies beside the picture that says nothing.
/// - Once nearly all has gone or is seen past, the rest goes too, at once, unless most of that is a hole: something
///   smaller may have gone out of sight together with it. What hung goes by itself, and what the picture does not show
///   stays, but for what a camera that looks down the corridor would not show if it never turned. The picture of a
///   camera that turns at times is believed once a second one says so.
/// - Of a cloud that is not organised the picture is a raster, in which what is thin leaves no hole: it is not seen
///   past while nothing may return on the rays that it would take.
/// - What leaves the picture at its upper border, within the corridor, is not seen to go by what is seen below it. Nor
///   is what leaves it at the lower border, from one cloud to the next, by what is seen over it, unless the same wall
///   is still there right above it, beside the corridor.
void forgive(Remembered& thing, const Pixels& picture, const NearFloor& floor, const Gaze& gaze);

}  // namespace safety_control_cloud
