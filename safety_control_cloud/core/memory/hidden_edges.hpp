// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "floor_strip.hpp"
#include "near_ground.hpp"
#include "pixels.hpp"
#include "thing.hpp"

namespace safety_control_cloud {

/// What a picture shows of the near floor.
struct Ground {
  const Pixels& picture;
  const NearGround& near;
  const FloorStrip& floor;
};

/// Of what stands too near to return, an edge may be seen alone, thinner than a thing that is found beside another one.
/// It leans in the picture and ends above the floor, or is hidden below by the rest. But right beside it the near
/// floor, and all from there up to as high as the edge is seen, returns nothing, over the width of a post.
/// Of the `things` of the same picture, tells those that may be such an edge: nearer than `near` [m] ahead of the
/// camera.
void note_edges(std::vector<Thing>& things, const Ground& ground, float near);

}  // namespace safety_control_cloud
