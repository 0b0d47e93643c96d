// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pixels.hpp"
#include "thing.hpp"

namespace safety_control_cloud {

/// What a picture says of a thing, in one of its spots.
enum class Evidence : std::uint8_t {
  Nothing,  ///< nothing returns, or too little to say that the thing has gone
  There,    ///< something returns as far away as the thing was
  Hidden,   ///< something returns before it
  Past,     ///< what returns around the spot lies behind the thing
};

/// A return proves little alone: sensors return stray ranges where they see nothing. What is behind a thing returns in
/// nearly all pixels around the spot that returned when the thing was seen, at ranges that agree, but for fewer than
/// half of them, which may show a part of it that is still there: at its edge it has moved by a pixel. And a thing that
/// has come too near to return lies farther from the middle of the picture than it did: no hole may be seen on that
/// way.
Evidence evidence_of(const Spot& spot, const Pixels& picture);

/// Whether there is a hole where the thing left none, wider than noise makes them: where it was seen, or where what
/// comes nearer has moved to.
bool leaves_a_hole(const Spot& spot, const Pixels& picture);

/// Whether what was seen in these spots may be nearer than the sensor sees and yet leave no hole in the picture, which
/// is a raster: if it came nearer by some distance, nothing would return on most of its rays.
bool may_lie_between_rays(std::vector<Spot> spots, const Pixels& picture);
/// The same of the floor that it stands on: whether nothing would return on most of the rays below it in these rows.
bool may_stand_between_rays(std::vector<Spot> spots, const std::vector<std::size_t>& rows, const Pixels& picture);

/// Whether the spot lies so near the picture's upper border that what comes nearer leaves the picture there.
bool leaves_at_the_top(const Spot& spot, const Pixels& picture);
/// The same of its lower border, of what has come `nearer` by so much [m] since it was seen: of a raster, which has
/// none, never.
bool leaves_at_the_bottom(const Spot& spot, const std::optional<float>& nearer, const Pixels& picture);

/// Where a thing at this distance [m] may be seen, by the noise of the sensor and the step of a cloud.
inline float noise_at(float distance) { return std::max(0.03f, 0.05f * distance); }

}  // namespace safety_control_cloud
