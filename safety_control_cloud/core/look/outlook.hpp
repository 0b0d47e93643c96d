// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <variant>

#include "../input/reading.hpp"
#include "corridor.hpp"
#include "placement.hpp"

namespace safety_control_cloud {

struct LookSettings;

/// The corridor as one camera looks down it: the limits and the place in their axes are one value, because neither
/// means anything without the other.
struct Outlook {
  Corridor corridor;
  std::optional<Placement> placement;  ///< none: the corridor lies in the camera's own frame

  Outlook(const Corridor& limits = {}, const std::optional<Placement>& place = std::nullopt)
      : corridor(limits), placement(place) {}

  /// A return in the corridor's axes.
  Point placed(float x, float y, float z) const { return placement ? (*placement)(x, y, z) : Point(x, y, z); }

  /// A point of the corridor's axes in the camera's frame: the other way round.
  Point seen_from_camera(const Point& placed) const;

  /// Where the camera is, in the corridor's axes.
  Point camera() const {
    if (!placement) return Point(0.0f, 0.0f, 0.0f);
    const auto& [x, y, z] = placement->rows;
    return Point(x[3], y[3], z[3]);
  }
};

/// What a camera that is placed so looks down by these settings. NoTransform also where the two do not belong together:
/// the settings name a frame and the camera is in none, or the other way round.
std::variant<Outlook, NoTransform> outlook_of(const LookSettings& look, const Placing& placing);

/// The points of a reading that is readable, as these settings mean them.
View view_in(const Reading& reading, const LookSettings& look);

}  // namespace safety_control_cloud
