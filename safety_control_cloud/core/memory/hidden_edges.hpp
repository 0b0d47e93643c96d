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

/// Of what stands too near to return, an edge may be seen, a column or two wide, which ends above the floor where it
/// leans in the picture: below it the floor is seen. But right beside it the near floor, and all from there up to its
/// foot, returns nothing. What is seen there, or in the outermost column of the picture, may have its foot beside it,
/// unseen. `things` are those of the same picture, once the near ground has placed them.
void place_hidden_edges(std::vector<Thing>& things, const Ground& ground);

}  // namespace safety_control_cloud
