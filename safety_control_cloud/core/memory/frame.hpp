// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "../look/ray_lines.hpp"
#include "thing.hpp"

namespace safety_control_cloud {

/// Where the pixels of a picture lie, and which way they look.
struct Frame {
  std::size_t width = 0, height = 0;
  RayLines rays;

  /// But for a fraction of a pixel.
  bool operator==(const Frame& other) const;
};

/// What one picture takes of the angle of another: by it differ the sizes of things, which are told in pixels of a
/// square as wide as the picture. 1 where that is not known.
double share_of_angle(const Frame& one, const Frame& other);

/// A spot of one picture in another one of a camera that looks the same way: its place is known. Where the rays of
/// neither are known, both show the same. What the new picture does not show, or would not if the thing came nearer,
/// though the old one would have, of that it says nothing.
void place(Spot& spot, const Frame& from, const Frame& to);

}  // namespace safety_control_cloud
